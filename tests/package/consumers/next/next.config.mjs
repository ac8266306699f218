// A static site: pages are rendered at build time, in Node, and come alive in the browser.
export default {
  output: 'export', basePath: '/next', devIndicators: false,
  serverExternalPackages: ['lpquad'],
  turbopack: { root: import.meta.dirname },
};
