// Writes TypeDoc's reference of the package as Markdown into the folder that is given, a page for each entry point. TypeDoc reads
// the declarations that the package ships, so the package has to be built before. `npm run docs` starts this file.

import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Application } from 'typedoc';

const HERE = dirname(fileURLToPath(import.meta.url));
const SDK = join(HERE, '..', '..', 'dist', 'sdk');
const ENTRIES = ['index.d.ts', 'element/index.d.ts', 'frame/host.d.ts', 'inline.d.ts', 'portable.d.ts'];
const [folder] = process.argv.slice(2);

const app = await Application.bootstrapWithPlugins({
  plugin: ['typedoc-plugin-markdown'],
  entryPoints: ENTRIES.map((file) => join(SDK, file)),
  tsconfig: join(HERE, 'tsconfig.json'),
  name: 'Reference of the npm package',
  readme: 'none',
  disableSources: true,
  disableGit: true,
  excludeInternal: true,
  excludePrivate: true,
  excludeProtected: true,
  excludeExternals: true,
  sort: ['alphabetical'],
  // Every exported name has a sentence, and every link leads somewhere. Internal types may stay out of the reference.
  requiredToBeDocumented: ['Class', 'Function', 'Interface', 'TypeAlias', 'Variable'],
  validation: { notDocumented: true, invalidLink: true, invalidPath: true, notExported: false },
  outputs: [{ name: 'markdown', path: folder }],
  outputFileStrategy: 'modules',
  flattenOutputFiles: true,
  hidePageHeader: true,
  hideBreadcrumbs: true,
  useCodeBlocks: true,
  parametersFormat: 'table',
  interfacePropertiesFormat: 'table',
  classPropertiesFormat: 'table',
  typeDeclarationFormat: 'table',
  propertyMembersFormat: 'table',
  logLevel: 'Warn',
});
const project = await app.convert();
if (project === undefined) process.exit(1);
app.validate(project);
if (app.logger.hasErrors() || app.logger.hasWarnings()) process.exit(1);
await app.generateOutputs(project);
