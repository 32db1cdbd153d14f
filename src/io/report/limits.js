// Where a plan cannot be sailed as it is drawn, and which parts of the area the boat cannot enter.

const cutOff = {...data.cut_off, rings: data.cut_off.rings.map(decoded),
  list: data.cut_off.list.map((piece) => ({...piece, at: [...decoded(piece.at)]}))};
for (const plan of plans) {
  plan.violations = {...plan.violations, list: plan.violations.list.map((v) =>
    ({...v, line: decoded(v.line), at: [...decoded(v.at)]}))};
}

/** The area that safe water cuts off: hatched. */
function paintCutOff(map) {
  map.hatch(cutOff.rings, colour('cut'));
}

/** Black and yellow bars along the stretch, a numbered triangle at its middle. */
function paintViolations(map) {
  const list = plans[chosen].violations.list;
  for (const v of list) {
    map.stroke([v.line], '#000000', 7);
    map.stroke([v.line], '#ffd500', 4.5, [7, 8]);
  }
  list.slice(0, 20).forEach((v, i) => map.triangle(String(i + 1), v.at));
}

const violationNames = {
  'infeasible': (v) => 'infeasible ' + v.kind.replace('_', '-'), 'outside water': () => 'outside safe water',
  'tight turn': () => 'tight turn',
};

function place(at) { return fileText([at[0], at[1]]); }

function row(name, show, ...cells) {
  return element('tr', {}, element('td', {}, element('button', {type: 'button', onclick: show,
    'aria-label': 'Zoom to ' + name}, name)), ...cells);
}

function listLimits() {
  const plan = plans[chosen];
  $('limits-of').textContent = plan.name;
  const rows = plan.violations.list.map((v, k) => row('▲ ' + (k + 1), () => showBox(v.box),
    element('td', {class: 'l'}, violationNames[v.what](v)), element('td', {}, number(v.length_m, 1) + ' m'),
    element('td', {class: 'l wrap'}, v.reason), element('td', {}, place(v.at))));
  const pieces = cutOff.list.map((piece, k) => row('▨ ' + (k + 1), () => showBox(piece.box),
    element('td', {class: 'l'}, 'area cut off'), element('td', {}, square(piece.area_m2)),
    element('td', {class: 'l wrap'}, 'outside the boat’s safe water; its cells still count in the coverage'),
    element('td', {}, place(piece.at))));
  const f = plan.figures;
  $('limits-sum').textContent = [
    plan.violations.count
      ? `${f.infeasible_legs} infeasible leg${f.infeasible_legs === 1 ? '' : 's'} (${short(f.infeasible_m)}), ${short(f.outside_water_m)} outside ` +
        `safe water, ${short(f.tight_turn_m)} tighter than the vehicle turns, ${f.sharp_corners} ` +
        `corner${f.sharp_corners === 1 ? '' : 's'} that cannot be sailed as drawn.`
      : 'The path stays in safe water and bends no tighter than the vehicle turns.',
    cutOff.count
      ? `Safe water cuts off ${square(cutOff.area_m2)} (${number(cutOff.share_pct, 2)} %) of the survey area in ` +
        `${cutOff.count} piece${cutOff.count === 1 ? '' : 's'}.`
      : 'Safe water reaches all of the survey area.',
    plan.violations.count > plan.violations.list.length
      ? `The first ${plan.violations.list.length} of ${plan.violations.count} are listed.` : '',
  ].filter(Boolean).join(' ');
  const head = element('thead', {}, element('tr', {}, ...[['Zoom', ''], ['What', 'l'], ['Size', ''], ['Why', 'l'],
    ['x, y', '']].map(([text, name]) => element('th', {class: name}, text))));
  $('limits').replaceChildren(...(rows.length + pieces.length
    ? [element('table', {}, head, element('tbody', {}, ...rows, ...pieces))] : []));
  $('limits').hidden = rows.length + pieces.length === 0;
}
