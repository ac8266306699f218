// Elements from names, properties and children: all the template language there is.

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} name
 * @param {Record<string, any> | null} [properties]  `on…` are listeners, `aria-…`, `data-…` and
 *   `role` attributes, the others properties
 * @param {...(Node | string | null | undefined | false)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function h(name, properties, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties ?? {})) {
    if (value === undefined) continue;
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (/^(aria-|data-|role$|for$|list$)/.test(key)) element.setAttribute(key, value);
    else /** @type {any} */ (element)[key] = value;
  }
  element.append(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** The same for SVG, whose properties are all attributes. @param {string} name  @param {Record<string, any> | null} [attributes] */
export function s(name, attributes, /** @type {(Node | string | false)[]} */ ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes ?? {}))
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (value !== undefined) element.setAttribute(key, value);
  element.append(...children.filter((child) => child !== false));
  return element;
}

/** Text in which L_p has a lower p, as elements. @param {string} text  @returns {(string | Node)[]} */
export const withSubscripts = (text) => text.split(/(?<=\bL)_(p)\b/).map((part, i) => (i % 2 === 1 ? h('sub', null, part) : part));

/** The same where there are only letters: tooltips, and what is spoken. @param {string} text */
export const withoutSubscripts = (text) => text.replace(/(?<=\bL)_(?=p\b)/g, '');

/** Sets only what differs: screen readers speak at every change. @param {Element} element @param {string} text */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}
