// What is shown, and with which settings: the views of the picture with their legends, and a group of choices for each setting.
// SPDX-License-Identifier: MIT
(explore => {
  'use strict';

  const { element } = explore;
  const STAGE = 'stage ';
  const MOST_RADIOS = 5; // values of a setting; more go into a list

  const swatches = legend => !legend || !legend.length ? [] : [element('ul', { className: 'legend', 'aria-label': 'Legend' }, ...legend.map(([color, label]) =>
    element('li', {}, element('span', { className: 'swatch', style: 'background: ' + color, 'aria-hidden': 'true' }), label)))];

  const scaleOf = scale => !scale ? [] : [element('p', { className: 'scale' }, scale.from, element('span', { className: 'ramp', 'aria-hidden': 'true',
    style: 'background: linear-gradient(to right, ' + scale.colors.join(', ') + ')' }), scale.to)];

  const paragraphs = (...texts) => texts.filter(Boolean).map(text => element('p', { textContent: text }));

  explore.Views = class {
    constructor(data, name, choose) {
      this.data = data;
      const has = layer => data.states.some(state => state[layer] !== undefined && state[layer] !== null);
      const both = new Set(data.views.map(view => view.pane)).size > 1;
      const options = [{ value: 'picture', label: 'Picture' }, ...(has('verdict') ? [{ value: 'errors', label: 'Errors' }] : []),
        ...(has('truth') ? [{ value: 'truth', label: 'Truth' }] : []),
        ...data.views.map((view, i) => ({ value: STAGE + i, label: view.label + (both ? ' (' + data.panes[view.pane].title + ')' : '') }))];
      this.radios = explore.radios('View', 'view-' + name, options, choose);
      this.element = this.radios.element;
      this.foot = element('div', { className: 'foot' });
    }

    /// The stage that a view shows, or undefined where it is the picture, its errors, or the truth. Two panes may have stages of the same id.
    stage(view) { return view.startsWith(STAGE) ? this.data.views[Number(view.slice(STAGE.length))] : undefined }

    /// What explains the picture stands below it. With a step there, it is the step's. `missing` are the panes whose errors are not known.
    set(view, step, missing) {
      this.radios.set(step ? '' : view);
      const shown = step || this.stage(view);
      if (shown) this.foot.replaceChildren(...swatches(shown.legend), ...scaleOf(shown.scale), ...paragraphs(shown.caption, shown.note));
      else if (view === 'errors') this.foot.replaceChildren(...swatches(this.data.verdictColors),
        ...paragraphs(this.data.verdictNote, ...missing.map(title => title + ' tells no visibility here, so its errors are not known.')));
      else if (view === 'truth') this.foot.replaceChildren(...swatches(this.data.truthColors),
        ...paragraphs('What is lit and what is in shadow, from exact geometry.'));
      else this.foot.replaceChildren();
    }
  };

  explore.Settings = class {
    /// `choose(variant)` is called with the number of a variant.
    constructor(data, name, choose) {
      this.data = data;
      this.controls = data.settings.map((setting, i) => {
        const options = setting.labels.map((label, value) => ({ value, label, disabled: this.variantOf(i, value) < 0 }));
        const chosen = value => choose(this.variantOf(i, Number(value)));
        return setting.values.length > MOST_RADIOS ? explore.select(setting.label, options, chosen)
          : explore.radios(setting.label, 'setting-' + i + '-' + name, options, chosen);
      });
      this.element = explore.group('settings-group', data.settings.length === 1 ? 'Setting' : 'Settings', ...this.controls.map(control => control.element));
      if (data.settings.length > 1) this.element.append(element('p', { className: 'note', textContent: 'One at a time: the others go back to their start.' }));
    }

    /// The variant in which one setting has a value, and all others are at their start; -1 where there is none.
    variantOf(setting, value) {
      const wanted = this.data.settings.map((each, i) => i === setting ? value : each.start);
      return this.data.variants.findIndex(variant => variant.every((each, i) => each === wanted[i]));
    }

    /// Which settings go back to their start from one variant to another, in words.
    putBack(from, to) {
      const { settings, variants } = this.data;
      return settings.filter((setting, i) => variants[from][i] !== setting.start && variants[to][i] === setting.start)
        .map(setting => setting.label + ' is back at ' + setting.labels[setting.start] + '.');
    }

    set(variant) { this.controls.forEach((control, i) => control.set(this.data.variants[variant][i])) }
  };
})(self.ShadowlabExplore = self.ShadowlabExplore || {});
