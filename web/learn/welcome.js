// What the page is, for those who have never been here.
/** @import { App } from '../app' */
import { h } from '../panels/dom.js';

/** Above everything in the panel that is open first, but for what is to be seen even on a phone. @param {App} app */
export function installWelcome({ actions }) {
  document.querySelector('#panel-domain > :not(.gallery)')?.before(h('p', { className: 'welcome' },
    'Draw an outline, and this page fills it with quadrilaterals while you watch. ',
    actions.button('learn.start', { text: 'New to meshes? Take the tour', className: 'plain' })));
}
