// One HTML file with everything in it, under a policy that lets nothing else run or load.
import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';
import { notices, workerModules } from './notices';

/** How a policy names a script or a style sheet that stands in a page. */
export const hash = (text: string) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** `others`: scripts that the page puts in later. */
function policy(script: string, style: string, others: string[]): string {
  const rules = [
    `default-src 'none'`,
    `script-src ${[script, ...others].map(hash).join(' ')} 'wasm-unsafe-eval'`,
    `style-src ${hash(style)}`,
    `worker-src blob:`,
    // The lines of a real robot, from a program on this computer.
    `connect-src ws://127.0.0.1:*`,
    `img-src blob: data:`,
    `base-uri 'none'`,
    `form-action 'none'`,
  ];
  return `<meta http-equiv="Content-Security-Policy" content="${rules.join('; ')}" />`;
}

/** A script that the page puts in itself, later, and the modules that it is made of. */
export interface Later {
  script: string;
  modules: string[];
}

/** Puts the page's one script and one style sheet into its HTML. */
export function oneFile(fileName: string, others: () => Promise<Later[]>): Plugin {
  return {
    name: 'labmouse-one-file',
    apply: 'build',
    enforce: 'post',
    async generateBundle(_, bundle) {
      const files = Object.values(bundle);
      const scripts = files.filter((file) => file.type === 'chunk');
      const assets = files.filter((file) => file.type === 'asset');
      const html = assets.find((file) => file.fileName === 'index.html');
      const styles = assets.filter((file) => file.fileName.endsWith('.css'));
      const [script] = scripts;
      const [sheet] = styles;
      if (!html || !script || !sheet || files.length !== 3)
        this.error(`the page has to be one script and one style sheet, and is ${files.map((file) => file.fileName)}`);
      // Neither may end the element that it stands in.
      const code = script.code.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
      const style = String(sheet.source).trim();
      const later = await others();
      const text = String(html.source)
        .replace(/\s*<script[^>]*src=[^>]*><\/script>/, '')
        .replace(/\s*<link[^>]*stylesheet[^>]*>/, '')
        .replace('<!-- labmouse:policy -->', () =>
          policy(
            code,
            style,
            later.map((one) => one.script),
          ),
        )
        .replace('</head>', () => `<style>${style}</style>\n  </head>`)
        .replace(
          '</body>',
          () =>
            `${notices([...script.moduleIds, ...workerModules, ...later.flatMap((one) => one.modules)])}\n  </body>`,
        )
        // Ahead of what a report carries, so that a report that was cut can say so.
        .replace('<!-- labmouse:report -->', (mark) => `<script type="module">${code}</script>\n    ${mark}`);
      for (const file of files) delete bundle[file.fileName];
      this.emitFile({ type: 'asset', fileName, source: text });
    },
  };
}
