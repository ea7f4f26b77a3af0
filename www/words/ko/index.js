// Every word in Korean.
export * as embed from './embed.js';
export * as exercise from './exercise.js';
export * as instead from './instead.js';
export * as keys from './keys.js';
export * as lab from './lab.js';
export * as lesson from './lesson.js';
export * as link from './link.js';
export * as messages from './messages.js';
export * as opening from './opening.js';
export * as pins from './pins.js';
export * as settings from './settings.js';
export * as sigmas from './sigmas.js';
export * as tables from './tables.js';
