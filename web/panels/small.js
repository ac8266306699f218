// What comes first in a tab where there is little room: on phones, upright or on their side. Their sheets of style have
// the same condition.

const small = matchMedia('(max-width: 760px) and ((max-aspect-ratio: 6/5) or (max-width: 480px)), (max-height: 500px)');

/** And into sight, however far down the tab was. @param {HTMLElement} section */
function toTop(section) {
  const body = section.parentElement;
  body?.prepend(section);
  body?.scrollTo(0, 0);
}

/**
 * Keeps a section at the top of its tab where there is little room, else where it is now. Not by style alone: what is seen
 * first has the focus first.
 * @param {HTMLElement} section  @param {() => boolean} [wanted]  whether nothing else should be first
 * @returns {() => void} call it when that changes
 */
export function firstWhereSmall(section, wanted = () => true) {
  const place = document.createComment('');
  section.before(place);
  const keep = () => {
    const first = small.matches && wanted();
    if (first === (section.previousSibling !== place)) return;
    const focused = document.activeElement;
    if (first) toTop(section);
    else place.after(section);
    if (focused instanceof HTMLElement && section.contains(focused)) focused.focus();  // moving it took the focus away
  };
  small.addEventListener('change', keep);
  keep();
  return keep;
}
