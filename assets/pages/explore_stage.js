// The stage: one picture, or two on both sides of a line that can be dragged. Above each half stands the name of its technique.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element, clamped } = explore;
  const LIFTED = 'rgba(255, 255, 255, 0.45)'; // veil over a picture without colours, so that the colours of a layer above stand out
  const KEY_STEP = 0.02;                      // of the width, for an arrow key at the line

  explore.Stage = class {
    /// `moved(split)` is called with the share of the width that is left of the line.
    constructor(data, moved) {
      this.data = data;
      this.moved = moved;
      this.split = 0.5;
      this.sides = [];
      this.canvas = element('canvas', { width: data.width, height: data.height, role: 'img' });
      this.names = [0, 1].map(() => element('span'));
      this.picture = element('div', { className: 'picture' }, this.canvas);
      this.element = element('div', { className: 'stage' },
        element('div', { className: 'frame' }, element('div', { className: 'names' }, ...this.names), this.picture));
      if (data.panes.length === 2) this.addSplit();
    }

    addSplit() {
      this.line = element('div', { className: 'split', role: 'slider', tabIndex: 0, 'aria-label': 'Line between the two pictures',
        'aria-orientation': 'horizontal', 'aria-valuemin': 0, 'aria-valuemax': 100, onkeydown: event => this.key(event) },
        element('span', { className: 'grip', 'aria-hidden': 'true' }, '\u25c2\u25b8'));
      let grabbed = 0;
      explore.draggable(this.line, (event, first) => {
        const at = explore.shareOf(event, this.picture)[0];
        if (first) grabbed = at - this.split;
        this.place(at - grabbed);
      });
      this.picture.append(this.line);
      this.place(this.split);
    }

    key(event) {
      const to = { ArrowLeft: this.split - KEY_STEP, ArrowDown: this.split - KEY_STEP, ArrowRight: this.split + KEY_STEP, ArrowUp: this.split + KEY_STEP,
        Home: 0, End: 1 }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      this.place(to);
    }

    place(split) {
      this.split = clamped(split, 0, 1);
      const percent = Math.round(100 * this.split), [left, right] = this.data.panes;
      this.line.style.left = 100 * this.split + '%';
      this.line.setAttribute('aria-valuenow', percent);
      this.line.setAttribute('aria-valuetext', percent === 0 ? 'only ' + right.title : percent === 100 ? 'only ' + left.title
        : percent + ' percent ' + left.title + ', the rest ' + right.title);
      this.draw();
      this.moved(this.split);
    }

    /// Which pane is seen at a share of the width.
    paneAt(x) { return this.sides.length === 2 && x >= this.split ? 1 : this.sides.length ? this.sides[0].pane : 0 }

    /// `sides`, one or two: {pane, picture, over, lifted}. `over` is a layer above, or null; a lifted picture is bright and without colours.
    show(sides, names, said) {
      this.sides = sides;
      this.names.forEach((name, i) => { name.textContent = names[i] || '' });
      this.canvas.setAttribute('aria-label', said);
      if (this.line) this.line.hidden = sides.length === 1;
      this.draw();
    }

    draw() {
      if (!this.sides.length) return; // not decoded yet
      const { width, height } = this.data, context = this.canvas.getContext('2d');
      const edge = this.sides.length === 2 ? Math.round(this.split * width) : width;
      context.clearRect(0, 0, width, height);
      this.sides.forEach((side, i) => {
        context.save();
        context.beginPath();
        context.rect(i ? edge : 0, 0, i ? width - edge : edge, height);
        context.clip();
        context.drawImage(side.picture, 0, 0);
        if (side.lifted) {
          context.globalCompositeOperation = 'saturation';
          context.fillStyle = '#808080';
          context.fillRect(0, 0, width, height);
          context.globalCompositeOperation = 'source-over';
          context.fillStyle = LIFTED;
          context.fillRect(0, 0, width, height);
        }
        if (side.over) context.drawImage(side.over, 0, 0);
        context.restore();
      });
    }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
