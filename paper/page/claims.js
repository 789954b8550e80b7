// SPDX-License-Identifier: Apache-2.0
// The table of claims: shows the rows that have every word that is typed, and one verdict only where
// its button is pressed.
'use strict';

class ClaimsFilter {
  constructor(root) {
    this.input = root.querySelector('input');
    this.buttons = [...root.querySelectorAll('button[data-verdict]')];
    this.count = root.querySelector('[data-part="count"]');
    this.rows = [...root.querySelectorAll('tbody tr')];
    this.texts = this.rows.map(row => ClaimsFilter.plain(row.textContent));
    this.input.addEventListener('input', () => this.apply());
    this.buttons.forEach(button => button.addEventListener('click', () => this.toggle(button)));
    this.apply();
  }

  /** "Lemma-2" and "lemma 2" are the same. */
  static plain(text) {
    return text.toLowerCase().replace(/[-\s]+/g, ' ').trim();
  }

  toggle(button) {
    const isPressed = button.getAttribute('aria-pressed') === 'true';
    this.buttons.forEach(other => other.setAttribute('aria-pressed', 'false'));
    button.setAttribute('aria-pressed', `${!isPressed}`);
    this.apply();
  }

  apply() {
    const words = ClaimsFilter.plain(this.input.value).split(' ');
    const pressed = this.buttons.find(button => button.getAttribute('aria-pressed') === 'true');
    let shown = 0;
    this.rows.forEach((row, i) => {
      const isShown = words.every(word => this.texts[i].includes(word)) &&
                      (!pressed || pressed.dataset.verdict === row.dataset.verdict);
      row.hidden = !isShown;
      shown += isShown ? 1 : 0;
    });
    this.count.textContent = `${shown} of ${this.rows.length} claims`;
  }

  showAll() {
    this.input.value = '';
    this.buttons.forEach(button => button.setAttribute('aria-pressed', 'false'));
    this.apply();
  }
}

/** A link to a row that the filter hides shows all rows again. */
function revealTarget(filter) {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target || !target.hidden) return;
  filter.showAll();
  target.scrollIntoView();
}

const claimsFilter = new ClaimsFilter(document.getElementById('claims'));
window.addEventListener('hashchange', () => revealTarget(claimsFilter));

/** Paper has no folds. */
window.addEventListener('beforeprint', () => {
  document.querySelectorAll('details').forEach(details => details.open = true);
});
