// Of what there are a few kinds that have names in every language. Where a kind is added to the run, its name is asked for here.

/** @typedef {'evolved' | 'hand' | 'paper-ep' | 'paper-arbitrary'} Driver */
/** @typedef {'hand' | 'map' | 'training' | 'luck'} Found */
/** @typedef {'begin' | 'moved' | 'limits' | 'seed' | 'setting' | 'undone' | 'redone' | 'given' | 'reset'} Restart */
/** @typedef {{ kind: 'every' | 'generation' | 'cost', value: number }} Until */
/** @typedef {'gains' | 'drives' | 'paper' | 'postures' | 'run' | 'seed' | 'clock' | 'settings' | 'parts' | 'lesson' | 'share'} Group */
/** @typedef {'free' | 'locked' | 'hidden'} Way */
/** @typedef {'cost' | 'sigmas'} LabCurve */
/** @typedef {'limits' | 'goal' | 'start' | 'weights' | 'settings'} Difference */

export {};
