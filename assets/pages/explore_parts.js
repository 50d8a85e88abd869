// Parts of which every control of the lab is made: elements, groups of choices, dragging, and numbers as words.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const PROPERTIES = ['className', 'textContent', 'hidden', 'disabled', 'checked', 'value', 'tabIndex'];
  const OF_SVG = ['svg', 'polygon', 'polyline', 'circle', 'text', 'g', 'title'];

  /// An element. Of its properties, "on..." are listeners; those that are null are left out.
  explore.element = (name, properties = {}, ...children) => {
    const made = OF_SVG.includes(name) ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
    for (const [key, value] of Object.entries(properties)) {
      if (value === null || value === undefined) continue;
      if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
      else if (PROPERTIES.includes(key)) made[key] = value;
      else made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
  };

  const element = explore.element;

  /// A text of the deck's as the program has written it: letters that mean something are escaped, and formulas are MathML.
  explore.marked = (target, markup) => { target.innerHTML = markup; return target };

  /// A group with a heading. Its name is read out with what is in it.
  explore.group = (className, heading, ...children) =>
    element('div', { className: 'group ' + className, role: 'group', 'aria-label': heading }, element('h3', { textContent: heading }), ...children);

  explore.button = (label, press, properties = {}) => element('button', { type: 'button', onclick: press, ...properties }, label);

  /// Radio buttons that look like keys. `options` are {value, label, disabled}; `choose` is called with the value.
  explore.radios = (heading, name, options, choose) => {
    const inputs = options.map(option => element('input', { type: 'radio', name, value: option.value, disabled: Boolean(option.disabled),
      onchange: () => choose(option.value) }));
    const keys = options.map((option, i) => element('label', {}, inputs[i], element('span', { textContent: option.label })));
    return { element: element('fieldset', { className: 'choices' }, element('legend', { textContent: heading }),
      element('div', { className: 'options' }, ...keys)),
      set: value => inputs.forEach(input => { input.checked = input.value === String(value) }) };
  };

  explore.select = (heading, options, choose) => {
    const list = element('select', { onchange: () => choose(list.value) }, ...options.map(option =>
      element('option', { value: option.value, disabled: Boolean(option.disabled), textContent: option.label })));
    return { element: element('label', { className: 'choices' }, element('span', { textContent: heading }), list),
      set: value => { list.value = String(value) } };
  };

  /// Calls `move(event)` while a pointer that went down on `target` is held, and `rest()` when it is let go.
  explore.draggable = (target, move, rest = () => {}) => {
    let held = null;
    target.addEventListener('pointerdown', event => {
      if (event.button !== 0 || held !== null) return;
      held = event.pointerId;
      target.setPointerCapture(held);
      move(event, true);
    });
    target.addEventListener('pointermove', event => { if (event.pointerId === held) move(event, false) });
    const end = event => { if (event.pointerId === held) { held = null; rest() } };
    target.addEventListener('pointerup', end);
    target.addEventListener('pointercancel', end);
  };

  /// Where an event is in a box: shares of its width and height, from the upper left corner.
  explore.shareOf = (event, box) => {
    const at = box.getBoundingClientRect();
    return [(event.clientX - at.left) / at.width, (event.clientY - at.top) / at.height];
  };

  explore.clamped = (value, least, most) => Math.min(most, Math.max(least, value));

  /// The numbers of a state in the order in which they are shown. `wrong` is the sum of false lit and false shadow; core errors are those of
  /// them that lie far from any true edge, so that they are no aliasing. Whole numbers have commas; others as many digits as they need.
  explore.NUMBERS = [
    { id: 'compared', label: 'Pixels compared', unit: '' },
    { id: 'wrong', label: 'Wrong pixels', unit: '' },
    { id: 'falseLit', label: 'false lit', unit: '', part: true },
    { id: 'falseShadow', label: 'false shadow', unit: '', part: true },
    { id: 'coreErrors', label: 'far from edges', unit: '', part: true, alone: 'Wrong pixels far from edges' },
    { id: 'edgeErrorPx', label: 'Edge error', unit: ' px' },
    { id: 'frameMs', label: 'Frame time', unit: ' ms' },
  ];
  explore.known = value => value !== null && value !== undefined;

  /// One of the numbers of a state, or undefined.
  explore.numberOf = (numbers, id) => {
    const of = numbers || {};
    return id === 'wrong' ? (explore.known(of.falseLit) && explore.known(of.falseShadow) ? of.falseLit + of.falseShadow : undefined) : of[id];
  };

  explore.numberWords = (value, unit = '') => {
    if (!explore.known(value)) return 'not known';
    const digits = Number.isInteger(value) || Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : 2;
    const [whole, part = ''] = value.toFixed(digits).split('.'), places = part.replace(/0+$/, '');
    return whole.replace(/\B(?=(\d{3})+$)/g, ',') + (places && '.' + places) + unit; // toLocaleString needs 30 ms when it is first called
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
