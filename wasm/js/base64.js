/** WebAssembly that travels as text. */
export const compileBase64 = async (text) =>
  WebAssembly.compile(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
