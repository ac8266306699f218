// What the page has of occt-import-js (LGPL-2.1): its files as published, in a folder of their own,
// none of them fetched before a CAD file is opened.
import script from 'occt-import-js/dist/occt-import-js.js?url';
import wasm from 'occt-import-js/dist/occt-import-js.wasm?url';
import licence from 'occt-import-js/dist/license.occt-import-js.txt?url';
import licenceOfOcct from 'occt-import-js/dist/license.occt.txt?url';

export const urls = { script, wasm };
export const licences = { 'occt-import-js': licence, 'Open CASCADE Technology': licenceOfOcct };
export const source = 'https://github.com/kovacsv/occt-import-js';
