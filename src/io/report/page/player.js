// A boat that sails the plan.

const player = {at: 0, speed: 60, timer: null};
const speeds = [10, 60, 300, 1200];
const boat = mark(plan().legs[0].points[0], element('span', {class: 'boat'},
  svg('svg', {viewBox: '-10 -14 20 28', width: 20, height: 28}, svg('path', {d: 'M0 -13 C6 -5 6 2 5 12 L-5 12 C-6 2 -6 -5 0 -13 Z'}))), {pane: 'boat'}).addTo(map);
const fanLine = L.polyline([], {pane: 'trail', interactive: false, color: '#ffb300', weight: 3}).addTo(map);
const trail = L.polyline([], {pane: 'trail', interactive: false, color: '#ffb300', weight: 3, opacity: 0.65}).addTo(map);
const ending = () => plan().figures.duration_s;

function legAt(t) {
  const legs = plan().legs;
  let low = 0, high = legs.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (legs[middle].times[0] <= t) low = middle; else high = middle - 1;
  }
  return legs[low];
}

/** Where the boat is on a leg at a time, which way it looks, and after which point. */
function onLeg(leg, t) {
  let i = 1;
  while (i + 1 < leg.times.length && leg.times[i] < t) ++i;
  const [a, b] = [leg.points[i - 1], leg.points[i]], whole = leg.times[i] - leg.times[i - 1];
  const share = whole > 0 ? Math.min(1, Math.max(0, (t - leg.times[i - 1]) / whole)) : 0;
  return {place: [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])], turn: Math.atan2(b[0] - a[0], b[1] - a[1]), after: i};
}

function fanAcross(leg, place, turn) {
  const depth = leg.sonar ? depthAt(place) : null;
  if (depth === null) return [];
  const reach = (degrees) => depth * Math.tan(degrees * Math.PI / 180);
  const [port, starboard] = [leg.port_deg, leg.stbd_deg].map(([low, high]) => reach((low + high) / 2));
  const [dx, dy] = [Math.cos(turn), -Math.sin(turn)];  // to starboard
  return [[place[0] - port * dx, place[1] - port * dy], [place[0] + starboard * dx, place[1] + starboard * dy]];
}

function boatText(leg, place) {
  const depth = depthAt(place);
  return [clock(player.at), legName(leg), leg.line === null ? '' : 'heading ' + headingText(leg), speedText(leg),
    depth === null ? '' : `about ${number(depth, 1)} m deep`, leg.log ? 'logging' : 'not logging'].filter(Boolean).join(' · ');
}

let spoken = 0;
function moveBoat(t, quiet = false) {
  player.at = Math.min(ending(), Math.max(0, t));
  const leg = legAt(player.at), {place, turn, after} = onLeg(leg, player.at);
  boat.setLatLng(at(place));
  if (boat.getElement()) boat.getElement().querySelector('svg').style.transform = `rotate(${turn}rad)`;
  fanLine.setLatLngs(line(fanAcross(leg, place, turn)));
  trail.setLatLngs(line([...leg.points.slice(0, after), place]));
  $('time').value = player.at;
  $('time').setAttribute('aria-valuetext', boatText(leg, place));
  chartsAt(player.at);
  // A reader of screens hears of a new leg, not of each frame.
  if (quiet && spoken === leg.index) return;
  spoken = leg.index;
  $('boat-says').textContent = boatText(leg, place);
}

function play(on) {
  if (player.timer) cancelAnimationFrame(player.timer);
  player.timer = null;
  $('play').textContent = on ? '❚❚ Pause' : '▶ Play';
  $('play').setAttribute('aria-pressed', on);
  if (!on) return;
  if (player.at >= ending()) player.at = 0;
  let before = null;
  const step = (now) => {
    moveBoat(player.at + (before === null ? 0 : (now - before) / 1000 * player.speed), true);
    before = now;
    if (player.at >= ending()) play(false); else player.timer = requestAnimationFrame(step);
  };
  player.timer = requestAnimationFrame(step);
}

$('play').addEventListener('click', () => play(!player.timer));
$('time').addEventListener('input', () => moveBoat(+$('time').value));
for (const speed of speeds) {
  const button = element('button', {type: 'button', 'aria-pressed': speed === player.speed, onclick: () => {
    player.speed = speed;
    for (const other of $('speeds').children) other.setAttribute('aria-pressed', other === button);
  }}, speed + ' ×');
  $('speeds').append(button);
}
choosers.push(() => {
  play(false);
  $('time').max = Math.ceil(ending());
  moveBoat(0);
});
