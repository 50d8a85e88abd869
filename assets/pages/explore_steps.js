// The steps of a technique: pass after pass, with the lines of its pseudocode that the pass carries out.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element } = explore;

  const lineOf = line => {
    const indent = line.length - line.trimStart().length;
    return element('li', { style: '--indent: ' + indent }, line.trim() || '\u00a0');
  };

  explore.Steps = class {
    /// `go(step)` is called with {pane, index}, or with null to leave the steps.
    constructor(data, name, go) {
      this.panes = data.panes;
      this.go = go;
      this.stepsOf = data.panes.map((pane, i) => data.steps.filter(step => step.pane === i));
      this.pane = this.stepsOf.findIndex(steps => steps.length);
      this.at = null;
      this.title = element('p', { className: 'step-title' });
      this.why = element('p');
      this.formulas = element('div');
      this.begin = explore.button('Step through', () => this.move(0));
      this.previous = explore.button('Previous', () => this.move(-1));
      this.next = explore.button('Next', () => this.move(1));
      this.out = explore.button('Out of steps', () => { this.go(null); this.begin.focus() });
      this.code = element('ol', { className: 'code' });
      this.codeGroup = element('div', { role: 'group', 'aria-label': 'Pseudocode', className: 'pseudocode' }, this.code);
      this.element = explore.group('steps-group', 'Steps');
      if (this.stepsOf.filter(steps => steps.length).length > 1) {
        this.radios = explore.radios('Steps of', 'steps-' + name, data.panes.map((pane, i) => ({ value: i, label: pane.title })),
          value => this.change(Number(value)));
        this.radios.set(this.pane);
        this.element.append(this.radios.element);
      }
      this.bar = element('div', { className: 'row' }, this.previous, this.next, this.out);
      this.element.append(this.begin, this.bar, this.title, this.why, this.formulas, this.codeGroup);
      this.set(null);
    }

    /// The step itself: {pane, title, lines, formula, at, note}.
    step(place) { return this.stepsOf[place.pane][place.index] }

    change(pane) {
      this.pane = pane;
      if (this.at) this.go({ pane, index: 0 }); else this.set(null);
    }

    move(by) {
      const index = this.at ? this.at.index + by : 0;
      if (index < 0 || index >= this.stepsOf[this.pane].length) return;
      this.go({ pane: this.pane, index });
      if (by === 0) this.next.focus();
    }

    words(place) {
      return 'Step ' + (place.index + 1) + ' of ' + this.stepsOf[place.pane].length + ': ' + this.step(place).title;
    }

    set(place) {
      this.at = place;
      const steps = this.stepsOf[this.pane];
      this.begin.hidden = Boolean(place);
      this.bar.hidden = this.why.hidden = this.formulas.hidden = this.codeGroup.hidden = !place;
      this.title.textContent = place ? this.words(place) + '.' : steps.length + (steps.length === 1 ? ' step of ' : ' steps of ') + this.panes[this.pane].title + '.';
      if (!place) return;
      this.previous.setAttribute('aria-disabled', place.index === 0); // not disabled: the focus would be lost
      this.next.setAttribute('aria-disabled', place.index === steps.length - 1);
      const step = this.step(place);
      this.why.textContent = step.why;
      this.formulas.replaceChildren(...step.formula.map(line => element('div', { className: 'formula', textContent: line })));
      if (this.shown !== place.pane) this.code.replaceChildren(...this.panes[place.pane].pseudocode.map(lineOf));
      this.shown = place.pane;
      [...this.code.children].forEach((line, i) => {
        if (step.lines.includes(i + 1)) line.setAttribute('aria-current', 'step'); else line.removeAttribute('aria-current');
      });
      this.codeGroup.hidden = !this.code.children.length;
    }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
