/** `kerfway/portable` for `require`: the same instances as with `import`. Its types are in `portable-types.d.cts`. */

module.exports = require('./portable.js');
