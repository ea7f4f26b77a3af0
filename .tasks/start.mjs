// npm start [-- --port N]: builds what is needed, serves the page, and builds the core again when its source changes.
import { watch } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildCore } from './build.mjs';
import { Failure, task, top } from './run.mjs';
import { installTools } from './tools.mjs';

await task(async () => {
  const { values } = parseArgs({ options: { port: { type: 'string', default: '5173' } } });
  const port = Number(values.port);
  if (!Number.isInteger(port) || port < 1 || port > 65535) {
    throw new Failure(`--port must be a whole number from 1 to 65535, not ${values.port}`);
  }
  await installTools();
  await buildCore();
  const { createServer } = await import('vite');
  const server = await createServer({ configFile: join(top, '.tasks', 'vite.config.js'), server: { port } });
  try {
    await server.listen();
  } catch (error) {
    await server.close();
    throw new Failure(`port ${port} cannot be had: ${error instanceof Error ? error.message : error}`);
  }
  console.log(`\nThe page is at ${server.resolvedUrls?.local[0]}\nPress Ctrl+C to stop.`);
  rebuildOnChange();
});

/** Vite sees the new pkg/ and reloads the page. */
function rebuildOnChange() {
  let building = false;
  let changed = false;
  watch(join(top, 'src'), { recursive: true }, async () => {
    changed = true;
    if (building) return;
    building = true;
    while (changed) {
      changed = false;
      await task(buildCore);
    }
    building = false;
  });
}
