// Why is this pixel lit, or in shadow? Rings on the picture, and for each the technique's own answer with its numbers and a section through the scene.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element } = explore;
  const FIRST_FACTS = 6;
  const LEAST_ALONG = 0.005; // shares of the picture: less is no way to the next ring

  explore.Ask = class {
    /// `toggle(on)` switches the rings; `paneAt(x)` is the pane that is seen at a share of the width; `lampAt()` is where the lamp is; `show()` brings
    /// the answer into view.
    constructor({ data, pack, name, picture, toggle, paneAt, lampAt, show, say }) {
      Object.assign(this, { data, pack, paneAt, lampAt, show, say });
      this.answers = new Map(data.ask.answers.map(([pane, lamp, point, offset, length]) => [pane + '/' + lamp + '/' + point, [offset, length]]));
      this.places = [...new Set(data.ask.answers.map(answer => answer[1]))].sort((a, b) => a - b);
      this.point = null;
      this.pane = 0;
      this.token = 0;
      this.all = false;
      const count = data.ask.points.length;
      this.rings = data.ask.points.map(([x, y], i) => element('button', { type: 'button', className: 'ring',
        style: 'left: ' + 100 * x + '%; top: ' + 100 * y + '%', 'aria-label': 'point ' + (i + 1) + ' of ' + count, 'aria-pressed': 'false', tabIndex: i ? -1 : 0 }));
      this.grid = element('div', { className: 'rings', role: 'group', 'aria-label': 'Points of the picture to ask about', hidden: true,
        onclick: event => this.clicked(event), onkeydown: event => this.key(event) }, ...this.rings);
      picture.append(this.grid);
      this.button = explore.button('Ask a pixel', () => toggle(this.grid.hidden), { 'aria-pressed': 'false' });
      this.hint = element('p', { className: 'note', textContent: 'Choose a ring on the picture.', hidden: true });
      this.verdict = element('p', { className: 'verdict' });
      this.facts = element('table', { className: 'facts' });
      this.more = explore.button('', () => { this.all = !this.all; this.tell() }, { className: 'more' });
      this.figure = element('img', { alt: '' });
      this.figureButton = explore.button(this.figure, () => this.enlarge(), { className: 'figure', 'aria-label': 'Enlarge the section' });
      this.large = element('img', { alt: '' });
      this.dialog = element('dialog', { className: 'large', 'aria-label': 'Section through the scene', onclick: () => this.dialog.close(),
        onclose: () => this.figureButton.focus() }, explore.button('Close', () => {}, { className: 'close' }), this.large);
      if (data.panes.length > 1) {
        this.radios = explore.radios('Answer of', 'ask-' + name, data.panes.map((pane, i) => ({ value: i, label: pane.title })), pane => {
          this.pane = Number(pane);
          this.answer();
        });
      }
      this.panel = element('div', { className: 'panel', role: 'group', 'aria-label': 'Answer', hidden: true },
        ...(this.radios ? [this.radios.element] : []), this.verdict, this.facts, this.more, this.figureButton);
      this.element = explore.group('ask-group', 'Ask', this.button, this.hint, this.panel, this.dialog);
    }

    /// A click of a finger or a mouse belongs to the nearest ring; one by keys to the ring that has the focus.
    clicked(event) {
      let chosen = this.rings.indexOf(event.target);
      if (event.detail > 0 || chosen < 0) {
        const { width, height } = this.grid.getBoundingClientRect(), [x, y] = explore.shareOf(event, this.grid);
        const far = this.data.ask.points.map(point => Math.hypot((point[0] - x) * width, (point[1] - y) * height));
        chosen = far.indexOf(Math.min(...far));
      }
      this.ask(chosen);
    }

    key(event) {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      const from = this.rings.indexOf(event.target), { points } = this.data.ask;
      if (!way || from < 0) return;
      event.preventDefault();
      let best = from, least = Infinity;
      points.forEach(([x, y], i) => {
        const by = [x - points[from][0], y - points[from][1]], along = by[0] * way[0] + by[1] * way[1], across = Math.abs(by[0] * way[1] + by[1] * way[0]);
        if (along > LEAST_ALONG && along + 2 * across < least) [best, least] = [i, along + 2 * across];
      });
      this.focusOn(best);
      this.rings[best].focus({ preventScroll: true });
    }

    focusOn(point) { this.rings.forEach((ring, i) => { ring.tabIndex = i === point ? 0 : -1 }) }

    ask(point) {
      this.point = point;
      this.pane = this.paneAt(this.data.ask.points[point][0]);
      this.focusOn(point);
      this.rings[point].focus({ preventScroll: true });
      this.answer();
    }

    /// Fetches the answer of the point at the lamp's place, and shows it unless another was asked for meanwhile.
    async answer() {
      if (this.point === null || this.grid.hidden) return;
      const token = ++this.token, piece = this.answers.get(this.pane + '/' + this.lampAt() + '/' + this.point);
      let told = { verdict: 'There is no answer of ' + this.data.panes[this.pane].title + ' for this point.', facts: [], figure: '' };
      if (typeof DecompressionStream === 'undefined') told.verdict = 'This browser cannot unpack the answers (it has no DecompressionStream).';
      else if (piece) {
        try { told = await this.pack.answer(...piece) } catch (broken) { told.verdict = 'The answer cannot be read.' }
      }
      if (token !== this.token) return;
      this.told = told;
      this.all = false;
      this.tell();
      this.show();
      this.say('Point ' + (this.point + 1) + ', ' + this.data.panes[this.pane].title + ': ' + told.verdict);
    }

    tell() {
      const { verdict, facts, figure } = this.told, more = facts.length > FIRST_FACTS;
      this.rings.forEach((ring, i) => ring.setAttribute('aria-pressed', i === this.point));
      this.hint.hidden = true;
      this.panel.hidden = false;
      if (this.radios) this.radios.set(this.pane);
      this.verdict.textContent = 'Point ' + (this.point + 1) + (this.radios ? '' : ', ' + this.data.panes[this.pane].title) + '. ' + verdict;
      this.facts.replaceChildren(...facts.slice(0, this.all ? facts.length : FIRST_FACTS).map(([name, value]) =>
        name ? element('tr', {}, element('th', { scope: 'row', textContent: name }), element('td', { textContent: value }))
          : element('tr', {}, element('td', { colspan: 2, textContent: value }))));
      this.facts.hidden = !facts.length;
      this.more.hidden = !more;
      this.more.textContent = this.all ? 'Fewer facts' : 'All ' + facts.length + ' facts';
      this.more.setAttribute('aria-expanded', this.all);
      this.figureButton.hidden = !figure;
      if (figure === this.drawing) return;
      this.drawing = figure;
      if (this.url) URL.revokeObjectURL(this.url);
      this.url = figure ? URL.createObjectURL(new Blob([figure], { type: 'image/svg+xml' })) : null;
      for (const image of [this.figure, this.large]) {
        if (figure) image.src = this.url; else image.removeAttribute('src');
        image.alt = 'Section through point ' + (this.point + 1) + ': ' + verdict;
      }
    }

    /// As wide as the window, or wider where that is too small to read; then its middle is seen first.
    enlarge() {
      if (this.dialog.showModal) this.dialog.showModal(); else this.dialog.setAttribute('open', '');
      this.dialog.scrollLeft = (this.dialog.scrollWidth - this.dialog.clientWidth) / 2;
    }

    /// Closes what is open: the large figure, or else the answer. False where nothing is.
    closeOne() {
      if (this.dialog.open) { this.dialog.close(); return true }
      if (this.panel.hidden) return false;
      this.clear();
      this.rings.find(ring => ring.tabIndex === 0).focus({ preventScroll: true });
      return true;
    }

    clear() {
      ++this.token;
      this.point = null;
      this.panel.hidden = true;
      this.hint.hidden = this.grid.hidden;
      this.rings.forEach(ring => ring.setAttribute('aria-pressed', 'false'));
    }

    set(on) {
      if (this.grid.hidden === !on) return;
      this.grid.hidden = !on;
      this.button.setAttribute('aria-pressed', on);
      this.clear();
    }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
