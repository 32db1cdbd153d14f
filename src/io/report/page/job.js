// The whole job: boats and sorties, cross-lines, the patch test.

/** '+2:05' after the beginning, or 'day 2, 06:00'. */
function jobClock(seconds, byDaylight) {
  const minutes = Math.round(seconds / 60), part = (v) => String(v).padStart(2, '0');
  if (!byDaylight) return `+${Math.floor(minutes / 60)}:${part(minutes % 60)}`;
  return `day ${1 + Math.floor(minutes / 1440)}, ${part(Math.floor(minutes % 1440 / 60))}:${part(minutes % 60)}`;
}

/** '1–14, 20, 19': neighbouring numbers are drawn together, in sailing order. */
function lineRuns(lines) {
  const runs = [];
  for (const n of lines) {
    const run = runs[runs.length - 1];
    const step = run ? n - run.last : 0;
    if (run && Math.abs(step) === 1 && (run.step === 0 || run.step === step)) Object.assign(run, {last: n, step});
    else runs.push({first: n, last: n, step: 0});
  }
  return runs.map(({first, last}) => (first === last ? first : first + '–' + last)).join(', ');
}

function sortieRow(job, sortie, before) {
  const name = [job.boats ? 'Boat ' + sortie.boat : '', `sortie ${sortie.sortie}`].filter(Boolean).join(', ');
  const show = element('button', {type: 'button', 'aria-label': `Put the boat at the start of ${name.toLowerCase()}`,
    onclick: () => moveBoat(before)}, name[0].toUpperCase() + name.slice(1));
  return element('tr', {}, element('th', {scope: 'row'}, show), cell(jobClock(sortie.begins_s, job.by_daylight)),
    cell(jobClock(sortie.begins_s + sortie.duration_s, job.by_daylight)), cell(number(sortie.duration_s / 3600, 2) + ' h'),
    cell(number(sortie.duration_with_contingency_s / 3600, 2) + ' h'), cell(number(sortie.length_m / 1000, 2) + ' km'),
    cell(number(sortie.logged_length_m / 1000, 2) + ' km'), cell(count(sortie.lines.length)), cell(lineRuns(sortie.lines), 'l wrap'));
}

function jobSum(job, f) {
  const {boats} = job, cross = f.cross_lines;
  return [
    job.berth_xy ? `Berth at ${job.berth_xy.map((v) => plainNumber(v, 1)).join(', ')}.` : '',
    job.longest_sortie_s ? `Sorties of ${number(job.longest_sortie_s / 3600, 2)} h at most, contingency included.` : '',
    job.sorties.length > 1 ? `Together ${number(job.sailed_s / 3600, 2)} h, ${number(job.sailed_to_undivided, 2)} times the ` +
      `${number(job.undivided_s / 3600, 2)} h of one boat in one go.` : '',
    boats ? `${boats.boats} boats: all done after ${number(boats.makespan_s / 3600, 2)} h, ${number(boats.makespan_to_one_boat, 2)} of one boat’s time; ` +
      (boats.within_a_swath_s > 0 ? `on lines within a swath of each other for ${time(boats.within_a_swath_s)}.` : 'on lines never within a swath of each other.') : '',
    cross ? `${plural(cross, 'cross-line')} of ${long(f.cross_lines_length_m)}: ${number(f.cross_lines_share_pct, 1)} % of the main scheme, ` +
      `${plural(f.cross_lines_crossings, 'crossing')}, ${count(f.cross_lines_right_angled)} near a right angle.` : '',
  ].filter(Boolean).join(' ');
}

function patchRow(test) {
  const places = test.passes.map((pass) => `${pass.line}: ${pass.from_xy.map((v) => plainNumber(v, 1)).join(', ')} → ` +
    `${pass.to_xy.map((v) => plainNumber(v, 1)).join(', ')}, ${number(pass.speed_mps, 1)} m/s`);
  const lines = (texts) => texts.map((text) => element('div', {}, text));
  const conditions = test.conditions.map((c) => element('div', {class: c.met ? '' : 'bad'}, `${c.met ? '✓' : '✗'} ${c.what}: ${c.figure} (asked: ${c.asks})`));
  return element('tr', {}, element('th', {scope: 'row', class: test.met ? 'good' : 'bad'}, (test.met ? '✓ ' : '✗ ') + test.test),
    element('td', {class: 'l'}, ...(places.length ? lines(places) : ['no lines'])),
    cell(test.reason, 'l wrap'), element('td', {class: 'l wrap'}, ...conditions));
}

function showJob(p) {
  const {job} = p;
  $('job-section').hidden = !job;
  if (!job) return;
  $('job-sum').textContent = jobSum(job, p.figures);
  let before = 0;
  const rows = job.sorties.map((sortie) => {
    const row = sortieRow(job, sortie, before);
    before += sortie.duration_s;
    return row;
  });
  $('sorties').replaceChildren(table('Boats and sorties', [headCell('Sortie'), ...['Begins', 'Ends', 'Hours', 'With contingency', 'Sailed', 'Logged', 'Lines']
    .map((name) => headCell(name)), headCell('Numbers, in order', 'l')], rows));
  $('patch-test').hidden = job.patch_test.length === 0;
  $('patch-test').replaceChildren(table('Patch test: places, reasons and conditions',
    ['Patch test', 'Line: from x, y → to x, y, speed', 'Why there', 'Conditions'].map((name) => headCell(name, 'l')), job.patch_test.map(patchRow)));
}
if (plans.some((p) => p.job)) choosers.push(showJob); else $('job-section').remove();
