/**
 * Kerfway for `require` in Node: the same instances of the same modules as with `import`. Node 20.19, 22.12 and later can
 * require ES modules directly; this entry is for tools that look for CommonJS. Its types are in `node-types.d.cts`.
 */

module.exports = require('./node.js');
