// The page of lessons: one lesson at a time. A choice is told right or wrong; then the picture is mended, and can be compared with what it was.
// The first answers are kept in this browser, where it allows that, and nowhere else.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element, button, clamped } = explore;
  const KEPT_AS = 'shadowlab-lessons'; // in localStorage
  const KEY_STEP = 2;                  // percent of the width, of the line between before and after
  const SWEEP = 700;                   // milliseconds in which the line comes to its place
  const still = matchMedia('(prefers-reduced-motion: reduce)');

  /// The first answers: which choice, by the name of the lesson.
  const answers = {
    given: new Map(),
    isKept: true,
    read() {
      this.given.clear();
      try {
        for (const [name, choice] of Object.entries(JSON.parse(localStorage.getItem(KEPT_AS) || '{}'))) if (Number.isInteger(choice)) this.given.set(name, choice);
      } catch (refused) {
        this.isKept = !(refused instanceof DOMException);
      }
    },
    write() {
      try {
        if (this.given.size) localStorage.setItem(KEPT_AS, JSON.stringify(Object.fromEntries(this.given)));
        else localStorage.removeItem(KEPT_AS);
      } catch {
        this.isKept = false;
      }
    },
  };

  const status = element('p', { className: 'spoken', role: 'status' });
  const say = text => { status.textContent = text };
  const at = (element, name) => element.querySelector(name);

  class Lesson {
    constructor(section, index, count) {
      this.section = section;
      this.index = index;
      this.count = count;
      this.name = section.dataset.name;
      this.right = Number(section.dataset.right);
      this.heading = at(section, 'h2');
      this.heading.tabIndex = -1;
      this.title = at(section, '.title').textContent.slice(2);
      this.picture = at(section, '.picture');
      this.frames = ['before', 'after'].map(state => [...section.querySelectorAll('img.' + state)]);
      this.choices = [...section.querySelectorAll('.choices li')];
      this.now = { choice: null, isMended: false, frame: 0, split: 100 };
    }

    get first() {
      const choice = answers.given.get(this.name);
      return choice >= 0 && choice < this.choices.length ? choice : null;
    }

    /// Made when the lesson is opened for the first time. It begins as it was left.
    open() {
      if (!this.keys) this.build();
      if (this.now.choice === null) this.now.choice = this.first;
      this.refresh();
    }

    build() {
      this.keys = this.choices.map((item, i) => {
        const key = button('', () => this.choose(i));
        key.append(element('span', { className: 'letter', textContent: 'ABCD'[i] }), element('span', { className: 'text', textContent: item.textContent }), element('span', { className: 'said' }));
        item.replaceChildren(key);
        return key;
      });
      this.verdict = element('p', { className: 'verdict' });
      this.mendKey = button('Mend it', () => this.mend(), { className: 'main' });
      this.againKey = button('Ask me again', () => this.again());
      const answer = at(this.section, '.answer');
      answer.before(this.verdict);
      at(answer, '.happens').after(element('div', { className: 'deeds' }, this.mendKey, this.againKey));
      this.section.classList.add('built');
      this.addSplit();
      if (this.frames[0].length > 1) this.addFrames();
      const link = (to, text, name) => element('a', { className: 'button', href: '#' + (to === null ? '' : 'lesson-' + (to + 1)), 'aria-label': name }, text);
      const next = this.index + 1 < this.count ? this.index + 1 : null;
      at(this.section, '.head').append(element('nav', { className: 'links', 'aria-label': 'Lessons' },
        ...(this.index > 0 ? [link(this.index - 1, '\u2039', 'Lesson before')] : []), link(null, 'All', 'All lessons'),
        ...(next === null ? [] : [link(next, '\u203a', 'Next lesson')])));
      this.next = element('p', { className: 'next' }, link(next, next === null ? 'All lessons' : 'Next lesson \u203a'));
      at(this.section, '.talk').append(this.next);
    }

    addSplit() {
      this.slider = element('input', { type: 'range', min: 0, max: 100, step: KEY_STEP, 'aria-label': 'Line between before and after',
        oninput: () => this.place(Number(this.slider.value)) });
      this.line = element('div', { className: 'split', 'aria-hidden': 'true' });
      this.sides = ['before', 'after'].map((name, i) => element('div', { className: 'side ' + ['left', 'right'][i], textContent: name, 'aria-hidden': 'true' }));
      this.picture.append(this.line, ...this.sides);
      this.sliderRow = element('label', { className: 'slider' }, element('span', { textContent: 'before' }), this.slider, element('span', { textContent: 'after' }));
      at(this.section, '.stage').append(this.sliderRow);
      explore.draggable(this.picture, event => { if (this.now.isMended) this.place(100 * explore.shareOf(event, this.picture)[0]) });
    }

    addFrames() {
      const last = this.frames[0].length - 1;
      this.frameSlider = element('input', { type: 'range', min: 0, max: last, value: 0, oninput: () => this.turn(Number(this.frameSlider.value)) });
      at(this.section, '.stage').append(element('label', { className: 'slider' }, element('span', { textContent: 'Moment' }), this.frameSlider),
        element('p', { className: 'note', textContent: (last + 1) + ' moments of a movement: move the slider to and fro, and watch.' }));
    }

    turn(frame) {
      this.now.frame = frame;
      this.refresh();
    }

    place(split) {
      cancelAnimationFrame(this.sweeping);
      this.now.split = clamped(split, 0, 100);
      this.showSplit();
    }

    showSplit() {
      const percent = Math.round(this.now.split);
      this.picture.style.setProperty('--split', this.now.split + '%');
      this.slider.value = this.now.split;
      this.slider.setAttribute('aria-valuetext', percent === 0 ? 'only after' : percent === 100 ? 'only before' : percent + ' percent before, the rest after');
      this.sides[0].hidden = !this.now.isMended || percent < 15;
      this.sides[1].hidden = !this.now.isMended || percent > 85;
    }

    choose(choice) {
      if (this.now.choice !== null) return;
      this.now.choice = choice;
      if (this.first === null) {
        answers.given.set(this.name, choice);
        answers.write();
        score.refresh();
      }
      this.refresh();
      say(this.verdict.textContent + ' ' + at(this.section, '.happens').textContent);
    }

    /// The line sweeps over the picture, and stays in the middle of where to look: one half of that is as it was.
    mend() {
      const frame = at(this.picture, '.look').style, rest = parseFloat(frame.left) + parseFloat(frame.width) / 2;
      this.now.isMended = true;
      this.now.split = still.matches ? rest : 100;
      this.refresh();
      this.slider.focus({ preventScroll: true });
      say('Mended. ' + at(this.section, '.mends').textContent);
      if (still.matches) return;
      const start = performance.now(), sweep = now => {
        const share = clamped((now - start) / SWEEP, 0, 1);
        this.now.split = share < .6 ? 100 * (1 - share / .6) : rest * (share - .6) / .4;
        this.showSplit();
        if (share < 1) this.sweeping = requestAnimationFrame(sweep);
      };
      this.sweeping = requestAnimationFrame(sweep);
    }

    again() {
      cancelAnimationFrame(this.sweeping);
      Object.assign(this.now, { choice: null, isMended: false });
      this.refresh();
      this.keys[0].focus();
      say('Asked again. ' + at(this.section, '.question').textContent);
    }

    refresh() {
      const { now, section } = this, isTold = now.choice !== null, isRight = now.choice === this.right;
      section.classList.toggle('told', isTold);
      section.classList.toggle('mended', now.isMended);
      at(section, '.answer').open = isTold;
      this.keys.forEach((key, i) => {
        const said = !isTold ? '' : i === this.right ? 'right' : i === now.choice ? 'not so' : '';
        key.className = { right: 'is-right', 'not so': 'is-wrong' }[said] || '';
        at(key, '.said').textContent = said && (i === now.choice ? 'your answer: ' : '') + said;
        key.setAttribute('aria-disabled', isTold);
      });
      this.verdict.hidden = !isTold;
      this.verdict.className = 'verdict ' + (isRight ? 'yes' : 'no');
      this.verdict.textContent = isRight ? '\u2713 Right.' : '\u2717 No. It is ' + 'ABCD'[this.right] + ': ' + at(this.choices[this.right], '.text').textContent + '.';
      this.mendKey.hidden = now.isMended;
      this.next.hidden = !isTold;
      this.sliderRow.hidden = this.line.hidden = !now.isMended;
      for (const frames of this.frames) frames.forEach((image, i) => image.classList.toggle('shown', i === now.frame));
      if (this.frameSlider) this.frameSlider.setAttribute('aria-valuetext', 'moment ' + (now.frame + 1) + ' of ' + this.frames[0].length);
      this.showSplit();
    }
  }

  const lessons = [...document.querySelectorAll('.lesson')].map((section, i, all) => new Lesson(section, i, all.length));
  const entries = [...document.querySelectorAll('#overview a')];

  const score = {
    line: element('p'),
    note: element('p', { className: 'note' }),
    forgotten: null,

    build() {
      this.key = button('', () => this.press());
      at(document, 'header').append(element('div', { className: 'score' }, this.line, this.key, this.note));
    },

    words() {
      const answered = lessons.filter(lesson => lesson.first !== null), right = answered.filter(lesson => lesson.first === lesson.right);
      return answered.length ? answered.length + ' of ' + lessons.length + ' answered, ' + right.length + ' right at the first try' : 'None of ' + lessons.length + ' answered yet';
    },

    /// Forgets the answers, or takes that back.
    press() {
      if (this.forgotten) answers.given = this.forgotten;
      const gone = this.forgotten ? null : answers.given;
      if (gone) answers.given = new Map();
      answers.write();
      for (const lesson of lessons) {
        Object.assign(lesson.now, { choice: null, isMended: false });
        if (lesson.keys) lesson.open();
      }
      this.refresh();
      this.forgotten = gone;
      this.label();
      say((gone ? 'Forgotten. ' : 'Taken back. ') + this.words());
    },

    label() {
      this.key.textContent = this.forgotten ? 'Take that back' : 'Forget my answers';
      this.key.hidden = !this.forgotten && !answers.given.size;
    },

    refresh() {
      this.forgotten = null;
      this.line.textContent = this.words();
      this.note.textContent = answers.isKept ? 'Kept on this device alone.' : 'This browser keeps nothing for this page: the answers last until it is closed.';
      this.label();
      entries.forEach((entry, i) => {
        const lesson = lessons[i], isRight = lesson.first === lesson.right;
        const mark = lesson.first === null ? ['', '', 'not answered yet'] : isRight ? ['yes', '\u2713', 'right at the first try'] : ['no', '\u2717', 'not right at the first try'];
        entry.replaceChildren(element('span', { className: 'mark ' + mark[0], 'aria-hidden': 'true', textContent: mark[1] }),
          element('span', {}, 'Lesson ' + (i + 1) + (lesson.first === null ? '' : ': ' + lesson.title)), element('span', { className: 'spoken', textContent: ', ' + mark[2] }));
      });
    },
  };

  /// The address says what is shown: #lesson-7, or the name of the lesson; else the overview.
  function follow(event) {
    const wanted = decodeURIComponent(location.hash.slice(1));
    const now = lessons.find(lesson => lesson.section.id === wanted || lesson.name === wanted);
    document.body.classList.toggle('reading', Boolean(now));
    for (const lesson of lessons) lesson.section.classList.toggle('now', lesson === now);
    document.title = (now ? 'Lesson ' + (now.index + 1) + ': ' : '') + 'Lessons on shadows';
    if (now) now.open();
    if (!event) return;
    scrollTo(0, 0);
    (now ? now.heading : at(document, 'h1')).focus({ preventScroll: true });
  }

  at(document, 'h1').tabIndex = -1;
  document.body.classList.add('scripted');
  document.body.append(status);
  answers.read();
  score.build();
  score.refresh();
  addEventListener('hashchange', follow);
  addEventListener('storage', event => { if (event.key === KEPT_AS || event.key === null) { answers.read(); score.refresh() } });
  follow();
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
