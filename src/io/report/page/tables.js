// Tables: lines, gaps, what cannot be sailed, rules, all figures, settings.

// --- lines -------------------------------------------------------------------------------------
const half = ([low, high]) => (low + high) / 2;
// [name, text, what it is sorted by]
const lineColumns = [
  ['Line', (leg) => leg.number, (leg) => leg.line ?? 1e9 + leg.index],
  ['Kind', kindName, kindName],
  ['Start: x, y', (leg) => leg.from.map((v) => plainNumber(v, 1)).join(', '), (leg) => leg.from[0]],
  ['End: x, y', (leg) => leg.to.map((v) => plainNumber(v, 1)).join(', '), (leg) => leg.to[0]],
  ['Heading', (leg) => headingText(leg) || '–', (leg) => leg.heading_deg ?? -1],
  ['Length', (leg) => plainNumber(leg.length_m, 1) + ' m', (leg) => leg.length_m],
  ['Depth', (leg) => depthText(leg) || '–', (leg) => leg.depth_m[0] ?? -1],
  ['Under keel', (leg) => keelText(leg) || '–', (leg) => leg.under_keel_m ?? 1e9],
  ['Fan, port / stbd', (leg) => fanText(leg) || 'off', (leg) => (leg.sonar ? half(leg.port_deg) + half(leg.stbd_deg) : -1)],
  ['Speed', (leg) => speedText(leg), (leg) => half(leg.speed_mps)],
  ['Takes', (leg) => clock(lasting(leg)), lasting],
  ['Begins at', (leg) => clock(leg.times[0]), (leg) => leg.times[0]],
];
const sorting = {column: lineColumns.length - 1, up: true};

function boxOf(points) {
  const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)].map((v) => 100 * v);
}

function listedLegs() {
  const legs = plan().legs.filter((leg) => $('all-legs').checked || !joining.has(leg.kind));
  const by = lineColumns[sorting.column][2], way = sorting.up ? 1 : -1;
  return [...legs].sort((a, b) => way * (by(a) > by(b) ? 1 : by(a) < by(b) ? -1 : 0) || a.index - b.index);
}

function legRow(leg) {
  const name = lineColumns[0][1](leg);
  const show = element('button', {type: 'button', 'aria-label': 'Show ' + legName(leg) + ' on the map', onclick: () => {
    visit(boxOf(leg.points), () => openLeg(leg, middleOf(leg).place));
    moveBoat(leg.times[0]);
  }}, name);
  return element('tr', {}, element('th', {scope: 'row'}, show), ...lineColumns.slice(1).map(([column, text]) =>
    cell(text(leg), column === 'Kind' ? 'l' : '')));
}

function sortBy(column) {
  sorting.up = sorting.column === column ? !sorting.up : true;
  sorting.column = column;
  listLines();
  $('lines').querySelectorAll('thead button')[column].focus();
}

function listLines() {
  const legs = listedLegs();
  const head = lineColumns.map(([name], i) => element('th', {scope: 'col', class: name === 'Kind' ? 'l' : '',
    'aria-sort': i === sorting.column ? (sorting.up ? 'ascending' : 'descending') : null},
  element('button', {type: 'button', class: 'sort', onclick: () => sortBy(i)}, name,
    element('i', {'aria-hidden': 'true'}, i !== sorting.column ? '' : sorting.up ? ' ▲' : ' ▼'))));
  $('lines').replaceChildren(table('Lines of ' + plan().name, head, legs.map(legRow)));
  const sum = (of) => legs.reduce((total, leg) => total + of(leg), 0);
  $('lines-sum').textContent = `${plural(legs.length, $('all-legs').checked ? 'leg' : 'line')}, ${long(sum((leg) => leg.length_m))}, ` +
    `${time(sum(lasting))}. Headings from true north, times from the start.`;
}

/** Columns between tabs, as sheets take them. */
async function copyLines() {
  const rows = [lineColumns.map(([name]) => name), ...listedLegs().map((leg) => lineColumns.map(([, text]) => text(leg)))];
  const text = rows.map((row) => row.join('\t')).join('\n');
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // Some browsers keep the clipboard from pages that are files.
    const box = document.body.appendChild(element('textarea', {class: 'away', 'aria-hidden': 'true'}, text));
    box.select();
    document.execCommand('copy');
    box.remove();
    $('copy-lines').focus();
  }
  $('lines-sum').textContent = `Copied ${plural(rows.length - 1, 'row')}.`;
}
$('copy-lines').addEventListener('click', copyLines);
$('all-legs').addEventListener('change', listLines);
choosers.push(listLines);

// --- gaps --------------------------------------------------------------------------------------
const shownGaps = 25;
function listGaps(p) {
  const rows = p.holidays.slice(0, shownGaps).map((gap, i) => element('tr', {},
    element('th', {scope: 'row'}, element('button', {type: 'button', 'aria-label': `Show gap ${i + 1} on the map`,
      onclick: () => visit(gap.box, tellOf(gap.target, gap.at))}, String(i + 1))),
    cell(square(gap.area_m2)), cell(gap.cause, 'l'), cell(fileText(gap.at))));
  $('gaps').replaceChildren(rows.length
    ? table('The largest gaps of ' + p.name, [headCell('Gap'), headCell('Area'), headCell('Cause', 'l'), headCell('x, y')], rows)
    : element('p', {class: 'readout'}, p.figures.holidays ? 'All gaps are too small for the list.' : 'No gaps.'));
}
choosers.push(listGaps);

// --- what cannot be sailed ---------------------------------------------------------------------
function limitRow(name, label, show, ...cells) {
  return element('tr', {}, element('th', {scope: 'row'}, element('button', {type: 'button', 'aria-label': `Show ${label} on the map`, onclick: show}, name)), ...cells);
}

function listLimits(p) {
  const cut = site.cutOff, f = p.figures;
  const rows = p.violations.list.map((v, k) => limitRow('▲ ' + (k + 1), 'violation ' + (k + 1), () => visit(v.box, tellOf(v.target, v.at)),
    cell(violationNames[v.what](v), 'l'), cell(number(v.length_m, 1) + ' m'), cell(v.reason, 'l wrap'), cell(fileText(v.at))));
  const pieces = cut.list.map((piece, k) => limitRow('▨ ' + (k + 1), 'cut-off piece ' + (k + 1), () => visit(piece.box),
    cell('area cut off', 'l'), cell(square(piece.area_m2)),
    cell('outside the boat’s safe water; its cells still count in the coverage', 'l wrap'), cell(fileText(piece.at))));
  $('limits-sum').textContent = [
    p.violations.count
      ? `${plural(f.infeasible_legs, 'infeasible leg')} (${short(f.infeasible_m)}), ${short(f.outside_water_m)} outside ` +
        `safe water, ${short(f.tight_turn_m)} tighter than the vehicle turns, ${f.sharp_corners} ` +
        `corner${f.sharp_corners === 1 ? '' : 's'} that cannot be sailed as drawn.`
      : 'The path stays in safe water and bends no tighter than the vehicle turns.',
    cut.count
      ? `Safe water cuts off ${square(cut.area_m2)} (${number(cut.share_pct, 2)} %) of the survey area in ${plural(cut.count, 'piece')}.`
      : 'Safe water reaches all of the survey area.',
    p.violations.count > p.violations.list.length ? `The first ${p.violations.list.length} of ${p.violations.count} are listed.` : '',
  ].filter(Boolean).join(' ');
  $('limits').replaceChildren(...(rows.length + pieces.length ? [table('Violations of ' + p.name + ', and parts of the area that the boat cannot enter',
    [headCell('Show'), headCell('What', 'l'), headCell('Size'), headCell('Why', 'l'), headCell('x, y')], [...rows, ...pieces])] : []));
  $('limits').hidden = rows.length + pieces.length === 0;
}
choosers.push(listLimits);

// --- the criterion -----------------------------------------------------------------------------
function ruleRow(rule) {
  const where = rule.where.slice(0, 3).map((p) => `${plainNumber(p.x, 1)}, ${plainNumber(p.y, 1)} (${square(p.area_m2)})`);
  const more = rule.failing_places > where.length && where.length ? `; ${count(rule.failing_places)} places in all` : '';
  return element('tr', {}, element('th', {scope: 'row', class: 'l ' + (rule.pass ? 'good' : 'bad')}, rule.pass ? '✓ passes' : '✗ fails'),
    cell(rule.name, 'l'), cell(rule.figure, 'l wrap'), cell(rule.asks, 'l wrap'), cell(where.join('; ') + more || '–', 'l wrap'));
}
function listRules(p) {
  const c = p.criterion;
  if (!c) return;
  $('criterion-sum').textContent = `${c.title}: judged over ${square(c.judged_m2)}; ${number(c.accepted_soundings_pct, 1)} % of ` +
    `${count(c.logged_soundings)} logged soundings within the limits.` +
    (c.out_of_reach_m2 > 0 ? ` ${square(c.out_of_reach_m2)} out of reach are not judged: ${square(c.hidden_m2)} that no place in safe water shows to the sonar, ${square(c.unsteerable_m2)} shown only from places that the boat cannot be steered through or held at.` : '');
  $('criterion').replaceChildren(table('What the criterion asks and what is predicted',
    ['', 'Rule', 'Predicted', 'Asked', 'Where it falls short: x, y'].map((name) => headCell(name, 'l')), c.rules.map(ruleRow)));
}
if (plans.some((p) => p.criterion)) choosers.push(listRules); else $('criterion-section').remove();

// --- all figures -------------------------------------------------------------------------------
// [label, figure, format, which is best, what is alarming]
const figures = [
  ['Coverage, logged pings', 'coverage_hit_logged_pct', percent, 'high'],
  ['Coverage, all pings', 'coverage_hit_pct', percent, 'high'],
  ['Coverage by beam footprints, logged', 'coverage_footprint_logged_pct', percent, 'high'],
  ['Coverage by beam footprints, all pings', 'coverage_footprint_pct', percent, 'high'],
  ['Cells with 2 or more logged soundings', 'coverage_hit_2_logged_pct', percent, 'high'],
  ['Cells with 5 or more logged soundings', 'coverage_hit_5_logged_pct', percent, 'high'],
  ['Cells with 5 or more soundings, all pings', 'coverage_hit_5_pct', percent, 'high'],
  ['Duration', 'duration_s', time, 'low'],
  ['Duration with contingency', 'duration_with_contingency_s', time, 'low'],
  ['Duration over the least hours', 'hours_ratio', ratio, 'low'],
  ['Energy, where the power is given', 'energy_wh', energy, 'low'],
  ['Length', 'length_m', long, 'low'],
  ['Length over area / W', 'length_ratio', ratio, 'low'],
  ['Pings', 'pings', count, ''],
  ['Mean spacing of pings', 'mean_ping_spacing_m', short, ''],
  ['Largest spacing of pings', 'largest_ping_spacing_m', short, ''],
  ['Overlap: soundings a covered cell, less 1', 'overlap_soundings_per_cell', ratio, ''],
  ['Cells sounded from two or more legs', 'several_legs_pct', percent, ''],
  ['Gaps, speckle too', 'holidays', count, ''],
  ['Largest gap', 'largest_holiday_m2', square, 'low'],
  ['All gaps together', 'holidays_total_m2', square, 'low'],
  ['Turns', 'turns', count, 'low'],
  ['of them 90° or more', 'sharp_turns', count, 'low'],
  ['Smallest turn radius', 'min_turn_radius_m', short, 'high'],
  ['Infeasible legs', 'infeasible_legs', count, 'low', (v) => v > 0],
  ['Path tighter than the vehicle turns', 'tight_turn_m', short, 'low', (v) => v > 0],
  ['Corners that cannot be sailed as drawn', 'sharp_corners', count, 'low', (v) => v > 0],
  ['Places where the path crosses itself', 'self_crossings', count, ''],
  ['Path along earlier stretches of itself', 'shared_m', long, ''],
  ['Path outside the water', 'outside_water_m', long, 'low', (v) => v > 0],
  ['of it over land or no-go', 'over_land_m', long, 'low', (v) => v > 0],
  ['of it over ground without data', 'over_unknown_m', long, 'low', (v) => v > 0],
  ['Least water under the keel', 'min_under_keel_m', short, 'high', (v) => v < 0],
  ['Planning time', 'planning_s', time, ''],
];
{
  const head = [headCell('Figure', 'l'), ...plans.map((p) => element('th', {scope: 'col', style: '--plan:' + p.tint}, element('span', {class: 'dot'}), p.name))];
  const rows = figures.map(([label, key, format, best, alarm]) => {
    const values = plans.map((p) => (key === 'planning_s' ? p.planning_s : p.figures[key]));
    const known = values.filter((v) => v !== null && v !== undefined);
    if (known.length === 0) return null;
    const top = best === 'high' ? Math.max(...known) : Math.min(...known);
    const differ = new Set(known.map(format)).size > 1;
    return element('tr', {}, element('th', {scope: 'row'}, label), ...values.map((v) => {
      if (v === null || v === undefined) return cell('–');
      const kind = alarm && alarm(v) ? 'alarm' : best && differ && format(v) === format(top) ? 'best' : '';
      return element('td', {class: kind, 'data-figure': key, 'data-value': v}, format(v));
    }));
  });
  $('figures').append(table('All figures of each plan', head, rows.filter(Boolean)));
}

// --- settings ----------------------------------------------------------------------------------
{
  const p = data.provenance;
  const add = (name, value, wide = '') => value !== '' && value !== null && $('settings').append(element('div', {class: wide}, element('dt', {}, name),
    element('dd', {}, Array.isArray(value) ? value.join(', ') : String(value))));
  for (const [name, value] of Object.entries(p.options)) add(name, value);
  add('seed', p.seed);
  add('coordinates', data.crs === 'none' ? 'those of the input file (no CRS)' : data.crs);
  add('input file', p.input_file);
  add('made by', p.program + ' ' + p.version + ', ' + p.command);
  add('input hash', p.input_hash, 'wide');
}
