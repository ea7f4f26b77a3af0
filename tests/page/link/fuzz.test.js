import { checkFile, checkLink, files, fuzz, links } from './fuzz.js';
import { test } from '../harness/once.js';

test('what has once failed is opened or refused', async () => {
  for (const link of links) checkLink(link);
  for (const file of files) await checkFile(file);
});

test('so are links, experiments and files of every kind; more by npm run fuzz', () => fuzz(1000, 1));
