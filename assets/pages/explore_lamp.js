// The lamp: it goes along a track of known positions. It is moved on the scene from above, on the picture where it is in view, and by a slider.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element } = explore;
  const LABEL = 12;                           // pixels of the type in the plan,
  const PLAN_WIDTH = 320, PLAN_HEIGHT = 240;  // which is at most so large, as the style has it
  const PLAY_STEP = 180;  // milliseconds from one position to the next

  const areaOf = outline => Math.abs(outline.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = outline[(i + 1) % outline.length];
    return sum + x * nextY - nextX * y;
  }, 0)) / 2;
  const points = list => list.map(point => point.join(',')).join(' ');

  /// The scene from above. An object's name is written into it, at its lower side, where it has room and hides no other name.
  function planOf(lamp, stops, others) {
    const { width, height, objects, eye, view } = lamp.plan, type = LABEL * Math.max(width / PLAN_WIDTH, height / PLAN_HEIGHT);
    const drawn = [...objects].sort((a, b) => areaOf(b.outline) - areaOf(a.outline));
    const taken = [], names = [];
    const write = (name, x, y) => names.push(element('text', { x, y: y + type * 0.35, 'font-size': type, 'text-anchor': 'middle', textContent: name }));
    const boxOf = (name, x, y) => { const half = name.length * type * 0.31; return [x - half, y - type * 0.6, x + half, y + type * 0.6] };
    if (eye) {
      const at = [explore.clamped(eye[0], type, width - type), eye[1] + type * (eye[1] + 1.7 * type > height ? -1.1 : 1.1)];
      taken.push(boxOf('eye', ...at));
      write('eye', ...at);
    }
    for (const object of [...drawn].reverse()) {
      const [[left, right], [top, bottom]] = [0, 1].map(axis => object.outline.map(point => point[axis]))
        .map(all => [Math.min(...all), Math.max(...all)]);
      const x = (left + right) / 2, y = bottom - type * 0.8, box = boxOf(object.name, x, y);
      const isOutside = box[0] < 0 || box[2] > width || box[1] < 0 || box[3] > height;
      const isLarger = box[2] - box[0] > right - left || 1.6 * type > bottom - top;
      const hidesAnother = taken.some(other => box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]);
      if (isOutside || isLarger || hidesAnother) continue;
      taken.push(box);
      write(object.name, x, y);
    }
    const said = 'The scene from above: ' + objects.map(object => object.name).join(', ') + '.';
    const plan = element('svg', { viewBox: '0 0 ' + width + ' ' + height, role: 'img', 'aria-label': said },
      ...drawn.map(object => element('polygon', { class: 'object', points: points(object.outline) }, element('title', { textContent: object.name }))));
    if (eye) {
      plan.append(...view.map(rim => element('polyline', { class: 'view', points: points([eye, rim]) })),
        element('circle', { class: 'eye', cx: eye[0], cy: eye[1], r: type * 0.45 }, element('title', { textContent: 'eye' })));
    }
    const line = points(lamp.positions.map(position => position.plan));
    plan.append(element(lamp.closed ? 'polygon' : 'polyline', { class: 'track', points: line }), stops, ...others, ...names);
    return plan;
  }

  explore.Lamp = class {
    /// `choose(index)` is called with the number of a position. `picture` is the box that the picture fills.
    constructor(lamp, picture, choose) {
      this.lamp = lamp;
      this.choose = choose;
      this.places = lamp.positions.map((position, i) => i);
      this.at = lamp.start;
      this.timer = null;
      this.stops = element('g', { class: 'stops' });
      this.others = lamp.others.map(name => element('circle', { class: 'other', r: lamp.plan.width / 50 }, element('title', { textContent: name })));
      this.handle = element('span', { className: 'lamp', 'aria-hidden': 'true' });
      this.plan = element('div', { className: 'plan', style: '--aspect: ' + lamp.plan.width / lamp.plan.height }, planOf(lamp, this.stops, this.others), this.handle);
      this.dragOn(this.plan, this.plan, position => [position.plan[0] / lamp.plan.width, position.plan[1] / lamp.plan.height]);
      this.slider = element('input', { type: 'range', min: 0, step: 1, 'aria-label': 'Lamp', oninput: () => this.moveTo(this.places[this.slider.value]),
        onkeydown: event => this.wrap(event) });
      this.said = element('p', { className: 'said' });
      this.note = element('p', { className: 'note', hidden: true });
      this.player = explore.button('Play', () => this.play(this.timer === null), { className: 'play' });
      this.element = explore.group('lamp-group', 'Lamp', this.plan, this.slider, this.said, this.note, element('div', { className: 'row' }, this.player,
        explore.button('Back to the start', () => this.moveTo(this.nearest(lamp.start)))));
      if (lamp.positions.some(position => position.picture)) {
        this.mark = element('span', { className: 'lamp', 'aria-hidden': 'true', title: 'Lamp' });
        this.dragOn(this.mark, picture, position => position.picture);
        picture.append(this.mark);
      }
    }

    /// Dragging on `target` goes to the nearest position. `placeOf` is its place in shares of `box`, or null.
    dragOn(target, box, placeOf) {
      explore.draggable(target, event => {
        const [x, y] = explore.shareOf(event, box), { width, height } = box.getBoundingClientRect();
        let best = null, least = Infinity;
        for (const index of this.places) {
          const place = placeOf(this.lamp.positions[index]);
          const distance = place ? Math.hypot((place[0] - x) * width, (place[1] - y) * height) : Infinity;
          if (distance < least) [best, least] = [index, distance];
        }
        if (best !== null) this.moveTo(best);
      });
    }

    /// Of the places that may be chosen, the one nearest along the track.
    nearest(index, places = this.places) {
      const count = this.lamp.positions.length;
      const far = place => { const by = Math.abs(place - index); return this.lamp.closed ? Math.min(by, count - by) : by };
      return places.reduce((best, place) => far(place) < far(best) ? place : best, places[0]);
    }

    moveTo(index) {
      this.play(false);
      if (index !== this.at) this.choose(index);
    }

    /// On a closed track the first position comes after the last, also by keys.
    wrap(event) {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key], last = this.places.length - 1, now = Number(this.slider.value);
      if (!by || !this.lamp.closed || (by > 0 ? now !== last : now !== 0)) return;
      event.preventDefault();
      this.moveTo(this.places[by > 0 ? 0 : last]);
    }

    play(on) {
      clearInterval(this.timer);
      this.timer = null;
      let by = 1;
      if (on) this.timer = setInterval(() => {
        const count = this.places.length, now = this.places.indexOf(this.at);
        if (!this.lamp.closed && (now + by < 0 || now + by >= count)) by = -by;
        if (count > 1) this.choose(this.places[(now + by + count) % count]);
      }, PLAY_STEP);
      this.player.textContent = on ? 'Stop' : 'Play';
    }

    /// Shows the lamp at a position. Where only some places may be chosen, `why` says so; otherwise it is empty.
    set(index, places, why) {
      const { positions, plan } = this.lamp, position = positions[index];
      if (places.length !== this.places.length || places.some((place, i) => place !== this.places[i]) || !this.slider.hasAttribute('max')) {
        this.places = places;
        this.slider.setAttribute('max', places.length - 1);
        this.stops.replaceChildren(...(why ? places : []).map(place =>
          element('circle', { cx: positions[place].plan[0], cy: positions[place].plan[1], r: plan.width / 60 })));
      }
      this.at = index;
      this.slider.value = places.indexOf(index);
      this.slider.setAttribute('aria-valuetext', position.said);
      this.said.textContent = position.said;
      this.note.textContent = why;
      this.note.hidden = !why;
      this.handle.style.left = 100 * position.plan[0] / plan.width + '%';
      this.handle.style.top = 100 * position.plan[1] / plan.height + '%';
      this.others.forEach((other, i) => ['cx', 'cy'].forEach((axis, k) => other.setAttribute(axis, position.others[i][k])));
      if (!this.mark) return;
      this.mark.hidden = !position.picture;
      if (position.picture) [this.mark.style.left, this.mark.style.top] = position.picture.map(share => 100 * share + '%');
    }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
