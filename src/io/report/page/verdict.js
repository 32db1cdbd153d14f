// The first screen: what the plan costs and gives, whether it passes, what speaks against it.

{
  const f = plans[0].figures;
  const extent = f.survey_area_m2 >= 1e5 ? number(f.survey_area_m2 / 1e6, 2) + ' km²' : square(f.survey_area_m2);
  $('facts').textContent = [
    extent, 'depth ' + number(data.depth.min_m, 1) + ' to ' + number(data.depth.max_m, 1) + ' m',
    'cells of ' + data.resolution_m + ' m', data.provenance.input_file, data.crs === 'none' ? 'no CRS' : data.crs,
  ].filter(Boolean).join(' · ');
}

function tile(value, label, kind = '') {
  return element('div', {class: 'tile ' + kind}, element('b', {}, value), element('span', {}, label));
}

/** The value itself stands beside its text, so that other programs can read the page. */
function tileOf(p, key, text, label) {
  const node = tile(text, label);
  node.dataset.figure = key;
  node.dataset.value = p.figures[key];
  return node;
}

function tilesOf(p) {
  const f = p.figures, logged = p.counted === 'logged';
  // The least hours are of all of the site: they are no measure for a plan of a part of it.
  const known = f.hours_ratio !== null && f.hours_ratio !== undefined && p.counted_pct >= 90;
  return [
    tileOf(p, 'duration_s', time(f.duration_s), 'under way'),
    tileOf(p, 'length_m', long(f.length_m), 'sailed'),
    tileOf(p, logged ? 'coverage_hit_logged_pct' : 'coverage_hit_pct', percent(p.counted_pct),
      logged ? 'covered by logged lines' : 'covered, all pings'),
    tileOf(p, logged ? 'coverage_hit_5_logged_pct' : 'coverage_hit_5_pct', percent(p.counted_5_pct), 'of cells with 5 soundings'),
    known ? tileOf(p, 'hours_ratio', ratio(f.hours_ratio) + ' ×', `the least hours (${time(3600 * f.least_hours)})`) : '',
    p.criterion ? tile(p.criterion.predicted_to_pass ? '✓ pass' : '✗ fail', 'predicted, ' + p.criterion.title,
      p.criterion.predicted_to_pass ? 'good' : 'bad') : '',
  ];
}

function showVerdict(p) {
  for (const id of ['verdict-of', 'map-of', 'job-of', 'lines-of', 'gaps-of', 'limits-of', 'criterion-of']) {
    if ($(id)) $(id).textContent = p.name;  // sections of what there is none of are left out
  }
  $('verdict').textContent = p.verdict;
  $('tiles').replaceChildren(...tilesOf(p));
  $('alarms').replaceChildren(...p.warnings.map((w) => element('li', {}, '⚠ ' + w)));
  $('alarms').hidden = p.warnings.length === 0;
  $('rules').replaceChildren(...(p.criterion ? p.criterion.rules : []).map((rule) =>
    element('li', {class: rule.pass ? 'good' : 'bad'}, element('b', {}, (rule.pass ? '✓ ' : '✗ ') + rule.name), ' ' + rule.figure)));
  $('rules').hidden = !p.criterion;
  $('gaps-text').textContent = p.gaps_text;
  $('notes').replaceChildren(element('summary', {}, p.notes.length === 1 ? 'A note' : p.notes.length + ' notes'),
    ...p.notes.map((note) => element('p', {class: 'says'}, note)));
  $('notes').hidden = p.notes.length === 0;
}
choosers.push(showVerdict);
$('overall').hidden = !$('overall').textContent;

// --- the planners side by side -----------------------------------------------------------------
function compareRow(p, i) {
  const f = p.figures, worst = p.warnings.length;
  const pick = element('button', {type: 'button', onclick: () => choose(i)}, p.name);
  p.row = element('tr', {style: '--plan:' + p.tint},
    element('th', {scope: 'row'}, element('span', {class: 'dot'}), pick, i === data.best ? element('span', {class: 'tag'}, 'best') : ''),
    cell(time(f.duration_s)), cell(f.hours_ratio === null ? '–' : ratio(f.hours_ratio) + ' ×'), cell(long(f.length_m)),
    cell(percent(p.counted_pct)), cell(percent(p.counted_5_pct)), cell(count(f.turns)),
    cell(worst ? plural(worst, 'warning') : 'none', worst ? 'alarm' : ''),
    ...(plans.some((q) => q.criterion) ? [cell(!p.criterion ? '–' : p.criterion.predicted_to_pass ? '✓ pass' : '✗ fail')] : []));
  return p.row;
}
if (plans.length > 1) {
  const counted = plans[0].counted === 'logged' ? 'logged' : 'covered';
  const names = ['Plan', 'Hours', '× least', 'Length', counted, '5 soundings', 'Turns', 'Warnings',
    ...(plans.some((q) => q.criterion) ? ['Predicted'] : [])];
  const compared = table('Hours, length and coverage of each plan', names.map((name) => headCell(name)), plans.map(compareRow));
  // A phone shows each row as a block whose figures carry their names. It stays a table to a screen reader.
  compared.setAttribute('role', 'table');
  for (const row of compared.querySelectorAll('tr')) {
    row.setAttribute('role', 'row');
    [...row.cells].forEach((c, i) => {
      c.setAttribute('role', c.tagName === 'TD' ? 'cell' : c.scope === 'col' ? 'columnheader' : 'rowheader');
      c.dataset.name = names[i];
    });
  }
  $('compare').append(compared);
  plans.forEach((p, i) => {
    p.tab = element('button', {type: 'button', onclick: () => choose(i)}, p.name);
    $('tabs').append(p.tab);
  });
  choosers.push(() => plans.forEach((p, i) => {
    p.tab.setAttribute('aria-pressed', i === chosen);
    p.row.classList.toggle('chosen', i === chosen);
  }));
} else {
  $('compare-section').remove();
}
