// Paper is light: while the page is printed, it has its light tones. Whoever paints for paper imports this first.
const root = document.documentElement;
let theme: string | undefined;

addEventListener('beforeprint', () => {
  theme = root.dataset.theme;
  root.dataset.theme = 'light';
});
addEventListener('afterprint', () => {
  if (theme === undefined) delete root.dataset.theme;
  else root.dataset.theme = theme;
});
