// The link to what is on the screen, or, where that is too long for a link, a file.
/** @import { App } from '../app' */
import { copy, download } from '../files/download.js';
import { fileNameOf } from '../files/names.js';
import { h, setText } from '../panels/dom.js';
import { icon } from '../panels/icons.js';
import { longestLink } from '../state/link.js';
import { projectEnding, projectText } from '../state/project_file.js';
import { closeOutside } from './help.js';

/** @param {App} app */
export function installShare(app) {
  const { actions } = app;
  const dialog = createDialog(app);
  actions.add(
    { id: 'page.share', label: 'Share a link', icon: 'share', keys: ['Shift+S'], run: () => void dialog.open() },
    { id: 'file.save', label: 'Save the project as a file', icon: 'file', keys: ['Ctrl+S'], run: () => save(app) },
  );
}

/** @param {App} app */
function save({ store, announce }) {
  const name = fileNameOf(store.project) + projectEnding;
  download(name, projectText(store.project), 'application/json');
  announce(`Saved as ${name}`);
}

/** @param {App} app */
function createDialog({ actions, keeping, announce }) {
  const address = h('input', { type: 'text', readOnly: true, id: 'share-address', 'aria-label': 'Link', onfocus: () => address.select() });
  const words = h('p', { id: 'share-words' });
  const copyLink = async () => {
    const copied = await copy(address.value);
    if (!copied) address.focus();
    const said = copied ? 'The link is copied.' : 'This browser does not let the page copy. The link is selected: copy it with Ctrl+C.';
    setText(words, said);
    announce(said);
  };
  const copyButton = h('button', { type: 'button', className: 'primary', onclick: () => void copyLink() }, icon('copy'), 'Copy the link');
  const fileButton = h('button', { type: 'button', onclick: () => actions.run('file.save') }, icon('download'), 'Save as a file');
  const close = h('button', { type: 'button', 'aria-label': 'Close', title: 'Close (Escape)', onclick: () => dialog.close() }, icon('close'));
  const dialog = h('dialog', { className: 'share', 'aria-labelledby': 'share-title', onclick: closeOutside },
    h('div', { className: 'dialog-head' }, h('h2', { id: 'share-title' }, 'Share'), close),
    words, address, h('div', { className: 'buttons' }, copyButton, fileButton));
  document.body.append(dialog);
  return {
    open: async () => {
      const fragment = await keeping.fragment();
      const fits = fragment.length <= longestLink;
      address.hidden = copyButton.hidden = !fits;
      address.value = fits ? location.href.replace(/#.*$/, '') + fragment : '';
      setText(words, fits
        ? 'Whoever opens this link sees the same drawing, options and layers, and gets the same mesh, bit for bit. Nothing is stored on a server.'
        : `This drawing needs ${Math.ceil(fragment.length / 1000)} kB, too much for a link that programs pass on whole. Send it as a file: the page opens it like any other.`);
      dialog.showModal();
    },
  };
}
