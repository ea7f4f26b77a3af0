// Every word in Korean.
export * as curves from './curves.js';
export * as disturbance from './disturbance.js';
export * as embed from './embed.js';
export * as generation from './generation.js';
export * as keep from './keep.js';
export * as keys from './keys.js';
export * as lab from './lab.js';
export * as landscape from './landscape.js';
export * as lesson from './lesson.js';
export * as link from './link.js';
export * as luck from './luck.js';
export * as messages from './messages.js';
export * as robustness from './robustness.js';
export * as settings from './settings.js';
export * as tables from './tables.js';
export * as training from './training.js';
