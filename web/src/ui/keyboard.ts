// SPDX-License-Identifier: Apache-2.0
import type { App } from '../app';
import { viewNames } from '../scene/camera';
import type { Viewer } from '../scene/viewer';

const takesText = 'input[type=text], input[type=search], select, textarea';
const takesSpace = 'button, input, select, textarea, summary, a[href]';
const takesArrows = 'input, select, textarea, [role=tab]';

export function listenToKeys(app: App, viewer: Viewer | null, focusSearch: () => void): void {
  const keys: Record<string, (event: KeyboardEvent) => void> = {
    ' ': () => app.toggle(),
    ArrowLeft: (event) => app.step(event.shiftKey ? -10 : -1),
    ArrowRight: (event) => app.step(event.shiftKey ? 10 : 1),
    Home: () => app.setTime(app.start),
    End: () => app.setTime(app.end),
    Escape: () => app.select(null),
    f: () => viewer?.fit(),
    '/': focusSearch,
  };
  viewNames.forEach((name, k) => (keys[String(k + 1)] = () => viewer?.view(name)));
  document.addEventListener('keydown', (event) => {
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey || isTaken(event)) return;
    event.preventDefault();
    action(event);
  });
}

// Controls keep the keys they use themselves. On a slider of time the arrows step as everywhere.
function isTaken({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.matches('.scrub')) return false;
  if (target.matches(takesText)) return key !== 'Escape';
  if (key === ' ') return target.matches(takesSpace) && !target.matches('.play');
  return (key.startsWith('Arrow') || key === 'Home' || key === 'End') && target.matches(takesArrows);
}
