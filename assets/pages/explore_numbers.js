// What was measured at the place of the lamp, and the task: to find a place at which a number is as asked.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element, NUMBERS, numberWords } = explore;

  explore.Numbers = class {
    constructor(panes) {
      this.panes = panes;
      this.cells = NUMBERS.map(() => panes.map(() => element('td')));
      const head = element('tr', {}, element('td'), ...panes.map(pane => element('th', { scope: 'col', textContent: pane.title })));
      this.rows = NUMBERS.map((number, i) => element('tr', { className: number.part ? 'part' : '' },
        element('th', { scope: 'row', textContent: number.label }), ...this.cells[i]));
      this.none = element('p', { className: 'note', textContent: 'Nothing was measured here.' });
      this.table = element('table', {}, head, ...this.rows);
      this.element = explore.group('numbers-group', 'Measured', this.table, this.none);
    }

    /// `numbers`: for each pane an object or null. Rows that no pane has a number for are left out.
    set(numbers) {
      const has = NUMBERS.map(number => numbers.some(each => each && each[number.id] !== undefined && each[number.id] !== null));
      NUMBERS.forEach((number, i) => {
        this.rows[i].hidden = !has[i];
        this.cells[i].forEach((cell, pane) => { cell.textContent = numberWords((numbers[pane] || {})[number.id], number.unit) });
      });
      this.table.hidden = !has.includes(true);
      this.none.hidden = has.includes(true);
    }

    words(numbers) {
      return numbers.map((each, pane) => {
        if (!each || each.coreErrors === undefined || each.coreErrors === null) return '';
        return this.panes[pane].title + ': ' + numberWords(each.coreErrors) + ' wrong pixels' +
          (each.compared === undefined || each.compared === null ? '.' : ' of ' + numberWords(each.compared) + '.');
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
      this.element = explore.group('task-group', 'Task', element('p', { className: 'question', textContent: task.question }),
        explore.button('Check this place', () => this.check()), this.answer, this.solved);
    }

    /// A browser may refuse its storage to a file.
    recall() { try { return localStorage.getItem(this.key) === 'solved' } catch (refused) { return false } }
    keep() { try { localStorage.setItem(this.key, 'solved') } catch (refused) { /* then it is forgotten with the page */ } }

    check() {
      const { pane, number, atLeast, atMost, told } = this.task, known = NUMBERS.find(each => each.id === number);
      const has = value => value !== null && value !== undefined;
      const value = (this.numbersOf(pane) || {})[number], unit = known ? known.unit : '', name = known ? known.label : number;
      const right = has(value) && (!has(atLeast) || value >= atLeast) && (!has(atMost) || value <= atMost);
      const asked = [has(atLeast) ? 'at least ' + numberWords(atLeast, unit) : '', has(atMost) ? 'at most ' + numberWords(atMost, unit) : '']
        .filter(Boolean).join(' and ');
      const here = name + ' of ' + this.title + ' here: ' + numberWords(value, unit) + '.';
      this.answer.textContent = right ? (/^right\b/i.test(told) ? '' : 'Right. ') + told + ' ' + here : 'Not yet. ' + here + ' Asked: ' + asked + '.';
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
