// What was measured at the place of the lamp, and the task: to find a place at which a number is as asked.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element, known, NUMBERS, numberOf, numberWords } = explore;

  explore.Numbers = class {
    /// `machine` is what the times were measured on, `size` in words that of the pictures.
    constructor(panes, machine, size) {
      this.panes = panes;
      this.cells = NUMBERS.map(() => panes.map(() => element('td')));
      const head = element('tr', {}, element('td'), ...panes.map(pane => element('th', { scope: 'col', textContent: pane.title })));
      this.rows = NUMBERS.map((number, i) => element('tr', { className: number.part ? 'part' : '' },
        element('th', { scope: 'row', textContent: number.label }), ...this.cells[i]));
      this.none = element('p', { className: 'note', textContent: 'Nothing was measured here.' });
      if (panes.length === 1) head.hidden = true; // its name stands above the picture
      this.table = element('table', { 'aria-label': 'Measured of ' + panes.map(pane => pane.title).join(' and ') }, head, ...this.rows);
      this.machine = element('p', { className: 'note', textContent: 'In pictures of ' + size + ' pixels, drawn by ' + machine + '.' });
      this.element = explore.group('numbers-group', 'Measured', this.table, this.none, this.machine);
    }

    /// `numbers`: for each pane an object or null. Rows that no pane has a number for are left out.
    set(numbers) {
      const has = NUMBERS.map(number => numbers.some(each => known(numberOf(each, number.id))));
      NUMBERS.forEach((number, i) => {
        this.rows[i].hidden = !has[i];
        this.cells[i].forEach((cell, pane) => { cell.textContent = this.text(numbers[pane], number) });
      });
      this.table.hidden = !has.includes(true);
      this.none.hidden = has.includes(true);
    }

    /// Where nothing is lit, or nothing in shadow, there is no edge to be wrong about.
    text(numbers, number) {
      const value = numberOf(numbers, number.id);
      return number.id === 'edgeErrorPx' && !known(value) && known(numberOf(numbers, 'compared')) ? 'no edge' : numberWords(value, number.unit);
    }

    words(numbers) {
      return numbers.map((each, pane) => {
        if (!known(numberOf(each, 'wrong'))) return '';
        const of = known(each.compared) ? ' of ' + numberWords(each.compared) : '';
        const core = known(each.coreErrors) ? ', ' + numberWords(each.coreErrors) + ' of them far from edges' : '';
        return this.panes[pane].title + ': ' + numberWords(numberOf(each, 'wrong')) + ' wrong pixels' + of + core + '.';
      }).filter(Boolean).join(' ');
    }
  };

  explore.Task = class {
    /// `numbersOf(pane)` gives what is measured now; `say` reads a text out. What is solved stays in this browser.
    constructor(task, title, key, numbersOf, say) {
      this.task = task;
      this.title = title;
      this.key = key;
      this.numbersOf = numbersOf;
      this.say = say;
      this.answer = element('p', { className: 'answer', hidden: true });
      this.solved = element('p', { className: 'solved', textContent: 'You have solved this.', hidden: !this.recall() });
      this.element = explore.group('task-group', 'Task', explore.marked(element('p', { className: 'question' }), task.question),
        explore.button('Check this place', () => this.check()), this.answer, this.solved);
    }

    /// A browser may refuse its storage to a file.
    recall() { try { return localStorage.getItem(this.key) === 'solved' } catch (refused) { return false } }
    keep() { try { localStorage.setItem(this.key, 'solved') } catch (refused) { /* then it is forgotten with the page */ } }

    check() {
      const { pane, number, atLeast, atMost, told } = this.task;
      const { label, alone, unit } = NUMBERS.find(each => each.id === number) || { label: number, unit: '' };
      const value = numberOf(this.numbersOf(pane), number), name = alone || label;
      const right = known(value) && (!known(atLeast) || value >= atLeast) && (!known(atMost) || value <= atMost);
      const asked = [known(atLeast) ? 'at least ' + numberWords(atLeast, unit) : '', known(atMost) ? 'at most ' + numberWords(atMost, unit) : '']
        .filter(Boolean).join(' and ');
      const here = name + ' of ' + this.title + ' here: ' + numberWords(value, unit) + '.';
      const praise = [/^right\b/i.test(told) ? '' : 'Right.', told, here].filter(Boolean).join(' ');
      if (right) explore.marked(this.answer, praise); else this.answer.textContent = 'Not yet. ' + here + ' Asked: ' + asked + '.';
      this.answer.classList.toggle('right', right);
      this.answer.hidden = false;
      if (right) {
        this.keep();
        this.solved.hidden = false;
      }
      this.say(this.answer.textContent);
    }

    /// At another place an answer about this one would mislead.
    moved() { this.answer.hidden = true }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
