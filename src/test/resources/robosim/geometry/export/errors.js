// Before a page's own program: remembers what went wrong.
const wrong = [];
addEventListener('error', e => wrong.push(String(e.message)));
addEventListener('unhandledrejection', e => wrong.push(String(e.reason)));
for (const level of ['error', 'warn']) console[level] = (...words) => wrong.push(words.join(' '));
