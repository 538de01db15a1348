// The share of contests that each mouse finishes as noise or variation grows, and what ended the others.
import { number } from '../ui/format';
import { Scrolling, Table } from '../ui/table';
import { LineChart } from './line-chart';
import type { ErrorCurves } from './error-curves';

interface TableProps {
  curves: ErrorCurves;
  title: string;
  cell(mouse: number, scale: number): string;
}

function CurveTable({ curves: { scaled, scales, mice }, title, cell }: TableProps) {
  const heads = ['mouse', ...scales.map((scale) => `${scaled} ${scale}`)];
  const rows = mice.map(({ name }, mouse) => [name, ...scales.map((_, scale) => cell(mouse, scale))]);
  return (
    <Scrolling label={title}>
      <Table heads={heads} rows={rows} caption={title} />
    </Scrolling>
  );
}

export function ErrorCurvesPicture({ curves }: { curves: ErrorCurves }) {
  const { scaled, scales, mice } = curves;
  const lines = () => ({
    xs: scales,
    lines: mice.map(({ name, finished }, mouse) => ({ mouse, name, values: finished })),
    labels: [scaled, 'contests finished, %'] as [string, string],
    axis: () => ({ splits: () => scales }),
    scale: { range: (): [number, number] => [scales[0], scales[scales.length - 1]] },
    cursor: { show: false },
    series: { points: { show: true, size: 5 } },
  });
  const endings = (mouse: number, scale: number) =>
    [...mice[mouse].ended[scale]]
      .sort(([a, many], [b, more]) => more - many || a.localeCompare(b))
      .map(([end, times]) => `${end} ${times}`)
      .join(', ') || '–';
  return (
    <div>
      <LineChart
        label={`Percentage of contests that each mouse finished, by ${scaled}. The table below has the same numbers.`}
        lines={lines}
        of={[curves]}
      />
      <CurveTable
        curves={curves}
        title="Contests finished, %"
        cell={(mouse, scale) => number(mice[mouse].finished[scale], 1)}
      />
      <details class="controls">
        <summary>What ended the others</summary>
        <CurveTable curves={curves} title="Contests without a score, by what ended them" cell={endings} />
      </details>
    </div>
  );
}
