// SPDX-License-Identifier: Apache-2.0
// What programs, such as the tests, ask of the page.
import type { App } from './app';
import type { Columns } from './data/columns';
import type { PlotPanel } from './plots/panel';
import type { Picture } from './ui/picture';

declare global {
  interface Window {
    jprim: { ready: Promise<void> } & Partial<ReturnType<typeof testInterface>>;
  }
}

export function testInterface(app: App, columns: Columns, plots: PlotPanel, picture: Picture | null) {
  return {
    setTime: (t: number) => {
      app.pause();
      app.setTime(t);
    },
    getTime: () => app.time,
    getPartMatrix: (id: string) => {
      picture?.update();
      return picture?.model.partMatrix(id)?.toArray() ?? null;
    },
    getDrawnShapes: () => {
      picture?.update();
      return picture?.model.drawn() ?? [];
    },
    getScreenPosition: (id: string) => {
      picture?.update();
      const anchor = picture?.model.anchor(id);
      return anchor ? picture!.viewer.project(anchor) : null;
    },
    select: (id: string | null) => app.select(id),
    getSelection: () => app.selection,
    getPlots: () => plots.plots.map((plot) => ({ columns: plot.columns.map((column) => column.name) })),
    addCurve: (table: string, name: string) => {
      const column = columns.find(table, name);
      if (column) plots.addCurve(column);
      return column !== undefined;
    },
    exportCsv: () => plots.csv(),
    play: () => app.play(),
    pause: () => app.pause(),
    fps: () => picture?.viewer.surface.fps() ?? 0,
    renderInfo: () => picture?.viewer.surface.info() ?? { triangles: 0, frames: 0, atRest: true },
  };
}
