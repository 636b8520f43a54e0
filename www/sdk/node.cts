/**
 * Kerfway by `require`, under Node: the same modules as by `import`, in the same instances. Node 20.19, 22.12 and later
 * can require them as they are; this entry is there for tools that look for CommonJS and for its types.
 */

import kerfway = require('./node.js');

export = kerfway;
