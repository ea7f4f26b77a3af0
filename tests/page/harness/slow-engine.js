// An engine that keeps one waiting, as a busy machine does.
import { engineOf } from '../../../www/core/direct.js';
import { createJobs } from '../../../www/core/jobs.js';
import './core.js';

/** The page's engine, the workers of which answer once they are let. */
export function slowEngine() {
  const jobs = createJobs(() => {});
  let open = () => {};
  /** @type {Promise<void>} */
  const gate = new Promise((resolve) => {
    open = resolve;
  });
  /** @type {import('../../../www/core/pool.js').Run} */
  const run = async ({ call, parts }) => {
    await gate;
    return parts.map((part) => /** @type {(...args: any[]) => any} */ (jobs[call])(...part));
  };
  const pool = { size: 1, run, soon: run, channel: () => ({ run }) };
  return { engine: engineOf({ pool: () => pool, lone: () => pool }), open };
}
