// The lab of a slide: what is chosen, what follows from it, and when the lab is built. Its parts are in the files before.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element } = explore;
  const REST = 300;      // milliseconds without a change until it is read out, and neighbours are decoded ahead
  const NEIGHBOURS = 2;  // places of the lamp to either side that are decoded ahead
  // Keys that belong to a control while it has the focus. PageUp and PageDown always turn slides: remote controls send them.
  const OF_CONTROLS = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End', ' ', 'Enter'];

  explore.Lab = class {
    constructor(section, root) {
      this.section = section;
      this.root = root;
      this.name = root.dataset.slide;
      this.data = JSON.parse(document.getElementById('explore-' + this.name).textContent);
      this.nameSettings();
      this.pack = new explore.Pack(this.name, this.data);
      this.states = new Map(this.data.states.map(state => [state.pane + '/' + state.variant + '/' + state.lamp, state]));
      this.now = { view: 'picture', lamp: this.data.lamp ? this.data.lamp.start : 0, variant: 0, step: null, asking: false };
      this.notes = [];
      this.ready = this.begin();
    }

    /// The picture first, and in a later frame what changes it.
    async begin() {
      try {
        for (const pane of this.data.panes.keys()) this.pack.picture(this.stateOf(pane).picture).catch(() => {}); // decoded while the stage is built
        this.build();
        this.refresh([], '');
        await this.draw();
        if (this.failed) return;
        await new Promise(seen => requestAnimationFrame(() => setTimeout(seen)));
        inPlace(() => this.addControls());
        this.refresh(...this.places(this.now));
        this.built = true;
        this.root.dataset.ready = true;
      } catch (broken) {
        this.fail(broken);
      }
    }

    /// Settings that the slide has changed belong to the name of a pane.
    nameSettings() {
      for (const pane of this.data.panes) if (pane.settings) pane.title += ' (' + pane.settings + ')';
    }

    build() {
      const { data, name, root } = this;
      this.track = data.lamp && data.lamp.positions.length > 1 ? data.lamp : null;
      this.stage = new explore.Stage(data, () => {});
      this.views = new explore.Views(data, name, view => this.change({ view, step: null }));
      this.status = element('p', { className: 'spoken', role: 'status' });
      this.column = element('div', { className: 'column' });
      root.style.setProperty('--aspect', data.width / data.height);
      root.replaceChildren(this.turners(), element('div', { className: 'left' }, this.stage.element, this.views.foot, this.views.element), this.column, this.status);
      this.listen();
    }

    addControls() {
      const { data, name, column } = this;
      if (data.task) {
        const heading = document.querySelector('h1');
        this.task = new explore.Task(data.task, data.panes[data.task.pane].title, 'shadowlab: ' + (heading ? heading.textContent : '') + ': ' + name,
          pane => this.stateOf(pane).numbers, text => this.say(text));
        column.append(this.task.element);
      }
      if (data.settings.length) {
        this.settings = new explore.Settings(data, name, variant => this.change({ variant }));
        column.append(this.settings.element);
      }
      this.numbers = new explore.Numbers(data.panes, data.machine, data.width + ' \u00d7 ' + data.height);
      column.append(this.numbers.element);
      if (data.lightNote) this.numbers.element.append(element('p', { className: 'note', textContent: data.lightNote }));
      if (this.track) {
        this.lamp = new explore.Lamp(this.track, this.stage.picture, lamp => this.change({ lamp }));
        if (matchMedia('(prefers-reduced-motion: reduce)').matches) this.lamp.player.remove();
        column.append(this.lamp.element);
      }
      if (data.steps.length) {
        this.steps = new explore.Steps(data, name, step => this.change({ step }));
        column.append(this.steps.element);
      }
      if (data.ask && data.ask.points.length) {
        this.ask = new explore.Ask({ data, pack: this.pack, name, picture: this.stage.picture, toggle: asking => this.change({ asking }),
          paneAt: x => this.stage.paneAt(x), lampAt: () => this.now.lamp, show: () => this.bringBack(), say: text => this.say(text) });
        column.append(this.ask.element);
      }
      const told = this.section.querySelector('.told'); // in a wide window the slide's words stand here; on a phone below
      if (told) column.append(element('div', { className: 'group words' }, ...told.cloneNode(true).childNodes));
      column.append(element('p', { className: 'note keys-note',
        textContent: 'In here the arrow keys belong to what is chosen. Esc gives them back to the slides.' }));
    }

    /// Where the lab is, no click on the slide turns it.
    turners() {
      const turn = by => show(now + by); // of the page's own script
      return element('div', { className: 'turners' }, explore.button('\u2039', () => turn(-1), { 'aria-label': 'Slide before' }),
        explore.button('\u203a', () => turn(1), { 'aria-label': 'Slide after' }));
    }

    listen() {
      const { root } = this;
      root.addEventListener('keydown', event => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        if (OF_CONTROLS.includes(event.key)) event.stopPropagation();
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        event.preventDefault();
        if (!(this.ask && this.ask.closeOne())) document.activeElement.blur();
      });
      for (const kind of ['touchstart', 'touchend']) root.addEventListener(kind, event => event.stopPropagation(), { passive: true });
    }

    /// What was drawn and measured of a pane; by default at the lamp's place and with the settings chosen.
    stateOf(pane, lamp = this.now.lamp, variant = this.now.variant) {
      return this.states.get(pane + '/' + variant + '/' + lamp) || this.states.get(pane + '/0/' + lamp) || { pane, picture: 0, numbers: null };
    }

    /// The step or the stage that is shown in place of the picture; null where it is the picture, its errors, or the truth.
    single(state = this.now) { return state.step ? this.steps.step(state.step) : this.views.stage(state.view) || null }

    /// Where the lamp may be, and why not everywhere.
    places(state) {
      const all = this.data.lamp ? this.data.lamp.positions.map((position, i) => i) : [0], single = this.single(state);
      const some = state.asking ? this.ask.places : single ? single.at.map(([lamp]) => lamp).sort((a, b) => a - b) : all;
      const what = state.asking ? 'Answers are given' : state.step ? 'Steps are shown' : 'This view is shown';
      const own = this.kept && this.kept.variant ? what + ' with the slide\'s own setting; yours comes back after them.' : '';
      if (!some.length || some.length === all.length) return [all, own];
      return [some, what + ' at ' + some.length + (some.length === 1 ? ' place' : ' places') + ' of the lamp. ' + own];
    }

    /// Stages, steps and answers exist for the first variant only, and at some places of the lamp.
    isLimited(state) { return Boolean(state.step || state.asking || this.views.stage(state.view)) }

    /// Changes what is chosen. One choice may undo another; setting and place of the lamp come back when stages, steps or answers are left.
    change(wanted) {
      if (!this.built) return void this.ready.then(() => { if (this.built) this.change(wanted) }); // it may have failed
      const before = this.now, next = { ...before, ...wanted };
      if (wanted.step) next.asking = false;
      if (wanted.asking) next.step = null;
      if (next.asking && this.views.stage(next.view)) { if (wanted.view) next.asking = false; else next.view = 'picture' }
      if (wanted.variant) {
        next.step = null;
        next.asking = false;
        if (this.views.stage(next.view)) next.view = 'picture';
      } else if (next.step || next.asking || this.views.stage(next.view)) next.variant = 0;
      const limited = this.isLimited(next), entered = limited && !this.isLimited(before);
      if (entered) this.kept = { lamp: before.lamp, variant: before.variant };
      else if (!limited && this.kept) {
        if (!('variant' in wanted)) next.variant = this.kept.variant;
        if (next.lamp === this.snapped) next.lamp = this.kept.lamp;
        this.kept = null;
      }
      const [places, why] = this.places(next);
      if (this.lamp && !places.includes(next.lamp)) next.lamp = this.lamp.nearest(next.lamp, places);
      if (entered) this.snapped = next.lamp;
      this.now = next;
      if (this.settings) this.notes.push(...this.settings.putBack(before.variant, next.variant));
      if (wanted.step) this.notes.push(this.steps.words(next.step) + '.');
      if (why && why !== this.why) this.notes.push(why);
      this.why = why;
      this.refresh(places, why);
      if (this.ask && next.asking && next.lamp !== before.lamp) this.ask.answer();
      if (this.task && (next.lamp !== before.lamp || next.variant !== before.variant)) this.task.moved();
      if ((next.step && !before.step) || (next.asking && !before.asking)) this.bringBack();
      this.draw();
    }

    refresh(places, why) {
      const { data, now, root } = this, numbers = data.panes.map((pane, i) => this.stateOf(i).numbers);
      root.classList.toggle('stepping', Boolean(now.step));
      root.classList.toggle('asking', now.asking);
      this.views.set(now.view, now.step ? this.single() : null,
        data.panes.filter((pane, i) => this.stateOf(i).verdict === undefined || this.stateOf(i).verdict === null).map(pane => pane.title));
      if (!this.numbers) return; // the picture is there, and its controls are not yet
      this.numbers.set(numbers);
      if (this.lamp) this.lamp.set(now.lamp, places, why);
      if (this.settings) this.settings.set(now.variant);
      if (this.steps) this.steps.set(now.step);
      if (this.ask) this.ask.set(now.asking);
      clearTimeout(this.resting);
      const news = this.built; // what stands there from the start is none
      this.resting = setTimeout(() => {
        if (news) this.say(this.notes.splice(0).join(' ') + ' ' + (now.step ? '' : this.numbers.words(numbers)));
        this.decodeAhead(places);
      }, REST);
    }

    say(text) {
      const said = text.trim();
      if (said && said !== this.status.textContent) this.status.textContent = said;
    }

    /// Steps and answers stand first in the column, and on a phone right below the picture. One may have scrolled away from there.
    bringBack() {
      this.column.scrollTop = 0;
      if (!wide.matches && this.root.getBoundingClientRect().top < 0) this.root.scrollIntoView({ block: 'start' });
    }

    /// The maps to show with the lamp at a place: {pane, picture, over, lifted} for each side of the line.
    wanted(lamp = this.now.lamp) {
      const { now, data } = this, single = this.single();
      if (single) return [{ pane: single.pane, picture: (single.at.find(([at]) => at === lamp) || single.at[0])[1], over: null, lifted: false }];
      return data.panes.map((pane, i) => {
        const state = this.stateOf(i, lamp), over = { errors: state.verdict, truth: state.truth }[now.view];
        return { pane: i, picture: state.picture, over: over === undefined ? null : over, lifted: now.view !== 'picture' };
      });
    }

    /// Draws what is wanted now. What is asked for while a picture is being decoded waits, and only the last of it is drawn.
    async draw() {
      this.stale = true;
      if (this.drawing) return;
      this.drawing = true;
      try {
        while (this.stale) {
          this.stale = false;
          const sides = this.wanted(), said = this.saidOf(sides), names = sides.map(side => this.data.panes[side.pane].title);
          const drawn = await Promise.all(sides.map(async side => ({ ...side, picture: await this.pack.picture(side.picture),
            over: side.over === null ? null : await this.pack.picture(side.over) })));
          this.stage.show(drawn, names, said);
          this.root.dataset.drawn = Number(this.root.dataset.drawn || 0) + 1;
        }
      } catch (broken) {
        this.fail(broken);
      }
      this.drawing = false;
    }

    saidOf(sides) {
      const { now, data } = this, titles = sides.map(side => data.panes[side.pane].title);
      const what = now.step ? this.steps.words(now.step)
        : { picture: 'Picture', errors: 'Errors', truth: 'Truth' }[now.view] || this.views.stage(now.view).label;
      return what + ', ' + (titles.length === 2 ? titles[0] + ' on the left, ' + titles[1] + ' on the right' : titles[0]) +
        (this.track ? '. Lamp: ' + data.lamp.positions[now.lamp].said : '') + '.';
    }

    decodeAhead(places) {
      if (!this.open || places.length < 2) return;
      const maps = [], at = places.indexOf(this.now.lamp), count = places.length;
      for (let by = 1; by <= NEIGHBOURS; ++by)
        for (const place of [places[(at + by) % count], places[(at - by % count + count) % count]])
          for (const side of this.wanted(place)) maps.push(side.picture, ...(side.over === null ? [] : [side.over]));
      const later = self.requestIdleCallback || (work => setTimeout(work, 50));
      const next = () => {
        if (!this.open || !maps.length || this.drawing) return;
        this.pack.picture(maps.shift()).then(() => later(next), () => {});
      };
      later(next);
    }

    /// The still slide is shown again, and a line says why.
    fail(broken) {
      this.failed = true;
      this.close();
      excuse(this.section, this.root, broken);
    }

    enter() { this.open = true }

    /// The slide is no longer seen: what can be decoded again is given back.
    close() {
      this.open = false;
      if (this.lamp) this.lamp.play(false);
      if (this.ask && this.ask.dialog.open) this.ask.dialog.close();
      this.pack.release();
    }
  };

  function excuse(section, root, broken) {
    section.classList.remove('explored');
    root.replaceChildren(element('p', { className: 'excuse',
      textContent: 'This browser cannot show the pictures of this slide (' + broken.message + '). The slide is shown as it is printed.' }));
    root.classList.add('excused');
  }

  const wide = matchMedia('(min-width: 701px)'), labs = new Map(), seen = new Set(); // `labs`: null for one that cannot be shown

  let moved = false; // by a hand; until then the window belongs to the slide that the address names
  for (const kind of ['touchstart', 'pointerdown', 'wheel', 'keydown'])
    addEventListener(kind, () => { moved = true }, { once: true, passive: true, capture: true });

  /// On a page that is scrolled, keeps what is at the top of the window there, though something above it gets longer.
  function inPlace(change) {
    if (wide.matches) return change();
    const top = [...document.querySelectorAll('section')].find(section => section.getBoundingClientRect().bottom > 1);
    const before = top ? top.getBoundingClientRect().top : 0;
    change();
    if (!moved && location.hash) document.querySelector('section.now').scrollIntoView({ block: 'start' });
    else if (top) scrollBy(0, top.getBoundingClientRect().top - before);
  }

  /// A lab is there while its slide is shown large, or near on a page that is scrolled.
  const isOpen = section => wide.matches ? document.body.classList.contains('one') && section.classList.contains('now') : seen.has(section);

  const sections = [...document.querySelectorAll('section.explorable')];
  let building = false;

  /// Labs are built one after the other, the one nearest to the top of the window first, so that none waits for its neighbours.
  async function update() {
    for (const [section, lab] of labs) {
      const open = isOpen(section);
      if (lab && Boolean(lab.open) !== open) if (open) lab.enter(); else lab.close();
    }
    if (building) return;
    building = true;
    for (let missing; (missing = sections.filter(section => isOpen(section) && !labs.has(section))).length;) {
      const from = section => Math.abs(section.getBoundingClientRect().top);
      await build(missing.length === 1 ? missing[0] : missing.reduce((best, section) => from(section) < from(best) ? section : best));
    }
    building = false;
  }

  async function build(section) {
    const root = section.querySelector('.explore');
    labs.set(section, null);
    try {
      if (typeof createImageBitmap === 'undefined') throw new Error('it has no createImageBitmap');
      inPlace(() => {
        section.classList.add('explored');
        labs.set(section, new explore.Lab(section, root));
      });
      labs.get(section).enter();
      await labs.get(section).ready;
    } catch (broken) {
      excuse(section, root, broken);
    }
  }

  if (self.IntersectionObserver) {
    const near = new IntersectionObserver(entries => {
      for (const entry of entries) if (entry.isIntersecting) seen.add(entry.target); else seen.delete(entry.target);
      update();
    }, { rootMargin: '50% 0px' });
    sections.forEach(section => near.observe(section));
  }
  const turned = new MutationObserver(() => {
    const now = sections.find(section => section.classList.contains('now'));
    if (now && now.getBoundingClientRect().top < innerHeight && now.getBoundingClientRect().bottom > 0) seen.add(now); // two frames before `near` tells it
    update();
  });
  for (const watched of [document.body, ...sections]) turned.observe(watched, { attributes: true, attributeFilter: ['class'] });
  wide.addEventListener('change', update);
  update();
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
