import { checkFile, checkLink, files, fuzz, links } from './fuzz.js';
import { test } from '../harness/once.js';

test('what has once failed is opened or refused', async () => {
  for (const link of links) checkLink(link);
  for (const file of files) await checkFile(file);
});

test('half a character, for which a file has no letter, is the same in the link that comes of it', () => {
  for (const key of ['handin=1', 'task=Park', 'who=4711', 'task=x&given=velocity-limits'])
    checkLink(`lab&v=1&task=Park.&aim=J%3C9&${key}\ud800`);
});

test('so are links, experiments and files of every kind; more by npm run fuzz', () => fuzz(1000, 1));
