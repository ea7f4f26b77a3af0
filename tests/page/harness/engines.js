// Finds the browser engines of this machine. It needs no package, because the tools are installed by what it finds.
import { existsSync, readdirSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { env, platform } from 'node:process';
import { fileURLToPath } from 'node:url';

/** @typedef {'chromium' | 'firefox' | 'webkit'} EngineName */

/**
 * @typedef {object} Engine
 * @property {EngineName} name
 * @property {string} browser the browser's program
 * @property {string | null} driver its WebDriver; null if selenium has to find one
 * @property {string} [bare] the program of the engine alone, without the browser around it, if the machine has it
 */

/** Where npm test puts what it builds. */
const tools = fileURLToPath(new URL('../../../.tools/bin', import.meta.url));

/** How to get the engines that a machine lacks. */
const HINTS = {
  linux: {
    chromium: 'apt-get install chromium chromium-driver (quicker with chromium-headless-shell beside them)',
    firefox: 'apt-get install firefox-esr (npm test builds its driver)',
    webkit: 'apt-get install webkit2gtk-driver xvfb',
  },
  darwin: {
    chromium: 'install Google Chrome',
    firefox: 'install Firefox (npm test builds its driver)',
    webkit: 'run "safaridriver --enable" once, then ENGINES=chromium,firefox,webkit npm test',
  },
  win32: {
    chromium: 'install Google Chrome',
    firefox: 'install Firefox (npm test builds its driver)',
    webkit: 'there is none for Windows',
  },
};

/**
 * The first of these programs that exists: a name is looked for on PATH, a path is taken as it is.
 * @param {string[]} candidates
 */
export function findProgram(candidates) {
  const folders = [...(env.PATH ?? '').split(delimiter), tools].filter(Boolean);
  const suffix = platform === 'win32' ? '.exe' : '';
  const places = candidates.flatMap((name) =>
    /[\\/]/.test(name) ? [name] : folders.map((folder) => join(folder, name + suffix)),
  );
  return places.find((place) => existsSync(place)) ?? null;
}

/** By which names a Python goes. */
export const pythons = ['python3', 'python', 'py'];

/** A path below each of the folders where Windows keeps programs. @param {string} path */
const inProgramFiles = (path) =>
  [env.PROGRAMFILES, env['PROGRAMFILES(X86)'], env.LOCALAPPDATA]
    .filter((folder) => folder !== undefined)
    .map((folder) => `${folder}\\${path}`);

/** WebKitGTK keeps its small test browser in a library folder that each distribution names differently. */
function miniBrowsers() {
  const libraries = ['/usr/lib', '/usr/lib64', '/usr/libexec'].filter((folder) => existsSync(folder));
  const folders = libraries.flatMap((library) => [
    library,
    ...readdirSync(library)
      .filter((name) => name.endsWith('-linux-gnu'))
      .map((name) => join(library, name)),
  ]);
  return folders.flatMap((folder) =>
    ['webkit2gtk-4.1', 'webkitgtk-6.0', 'webkit2gtk-4.0'].map((name) => join(folder, name, 'MiniBrowser')),
  );
}

/** @returns {Engine | null} */
function chromium() {
  const browser = findProgram([
    'chromium',
    'chromium-browser',
    'google-chrome',
    'google-chrome-stable',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    ...inProgramFiles('Google\\Chrome\\Application\\chrome.exe'),
  ]);
  const driver = findProgram(['chromedriver', 'chromium.chromedriver']);
  // Itself, not what starts it from PATH: that stays its parent, is ended in its place, and leaves it behind.
  const bare = findProgram(['/usr/lib/chromium/chromium-headless-shell']) ?? undefined;
  return browser === null ? null : { name: 'chromium', browser, driver, bare };
}

/** @returns {Engine | null} */
function firefox() {
  const browser = findProgram([
    'firefox-esr',
    'firefox',
    '/Applications/Firefox.app/Contents/MacOS/firefox',
    ...inProgramFiles('Mozilla Firefox\\firefox.exe'),
  ]);
  return browser === null ? null : { name: 'firefox', browser, driver: findProgram(['geckodriver']) };
}

/** @returns {Engine | null} */
function webkit() {
  if (platform === 'darwin') {
    // Safari is there on every Mac, but lets itself be driven only if its owner has allowed it.
    const allowed = env.ENGINES?.includes('webkit');
    return allowed ? { name: 'webkit', browser: 'Safari', driver: findProgram(['safaridriver']) } : null;
  }
  const browser = findProgram(miniBrowsers());
  const driver = findProgram(['WebKitWebDriver']);
  return browser && driver && findProgram(['Xvfb']) ? { name: 'webkit', browser, driver } : null;
}

/**
 * The engines to test with, and a hint for each that is absent. The environment's ENGINES=chromium,firefox
 * restricts them.
 * @returns {{ found: Engine[], absent: { name: EngineName, hint: string }[] }}
 */
export function findEngines() {
  const hints = platform in HINTS ? HINTS[/** @type {keyof typeof HINTS} */ (platform)] : HINTS.linux;
  const wanted = env.ENGINES?.split(',') ?? Object.keys(hints);
  const strangers = wanted.filter((name) => !(name in hints));
  if (strangers.length > 0) {
    throw new Error(`ENGINES may name ${Object.keys(hints).join(', ')}; it names ${strangers.join(', ')}`);
  }
  /** @type {Engine[]} */
  const found = [];
  /** @type {{ name: EngineName, hint: string }[]} */
  const absent = [];
  for (const [name, find] of /** @type {const} */ ([
    ['chromium', chromium],
    ['firefox', firefox],
    ['webkit', webkit],
  ])) {
    if (!wanted.includes(name)) continue;
    const engine = find();
    if (engine) found.push(engine);
    else absent.push({ name, hint: hints[name] });
  }
  return { found, absent };
}
