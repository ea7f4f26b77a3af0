// What single values follow from, as the core has it: for who has waited for the core, as every view has.
export { lawTerms, startsOnGrid, winsBout } from '../../pkg/ep_locomotion.js';
