// What the referees share: programs with a time limit, and jobs run side by side.
import { spawn } from 'node:child_process';

/** Ends with the code and all that was printed; never throws. */
export function run(command, args, seconds) {
  return new Promise((resolve) => {
    const child = spawn(command, args, { timeout: seconds * 1000, killSignal: 'SIGKILL' });
    let text = '';
    child.stdout.on('data', (data) => (text += data));
    child.stderr.on('data', (data) => (text += data));
    child.on('error', (error) => resolve({ code: -1, text: String(error) }));
    child.on('close', (code, signal) => {
      if (signal) text += signal === 'SIGKILL' ? `stopped after ${seconds} s` : `died of ${signal}`;
      resolve({ code: code ?? -1, text });
    });
  });
}

/** Runs [name, job] pairs, `workers` at a time; a job answers '' or what went wrong. */
export async function runJobs(jobs, workers) {
  let next = 0, passed = 0, failed = 0;
  async function worker() {
    while (next < jobs.length) {
      const [name, job] = jobs[next++];
      const start = Date.now();
      const fault = await job();
      fault ? ++failed : ++passed;
      const seconds = ((Date.now() - start) / 1000).toFixed(1);
      if (fault) console.log(`FAIL ${name} (${seconds} s)\n     ${fault.replaceAll('\n', '\n     ')}`);
    }
  }
  await Promise.all(Array.from({ length: workers }, worker));
  return { passed, failed };
}
