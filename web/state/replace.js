// Another project takes the place of the one on the page. How it is looked at stays as the person had it.
/** @import { App } from '../app' */
/** @import { Project } from '../types' */

/** @param {Pick<App, 'store' | 'stage' | 'keeping'>} app  @param {string} label  what was done, in words  @param {Project} project */
export function replaceProject({ store, stage, keeping }, label, project) {
  const { layers } = keeping;
  keeping.close();
  store.change(label, { ...project, layers });
  stage.fit();
}
