// Questions of which only the last one counts.

export interface Latest<Question> {
  /** Asks when nothing was asked for a moment and the question before is answered; those in between are left out. */
  ask(question: Question): void;
  /** Asks no more until the next one, and drops what is on its way. */
  cancel(): void;
}

/** `asking` answers one question at a time; `answered` and `failed` hear of the last. `delay` in milliseconds. */
export function createLatest<Question, Answer>(
  asking: (question: Question) => Promise<Answer>,
  answered: (answer: Answer, question: Question) => void,
  failed: (error: unknown, question: Question) => void,
  delay = 0,
): Latest<Question> {
  let newest = 0;
  let busy = false;
  let waiting: { question: Question } | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;

  async function next() {
    if (busy || !waiting) return;
    const { question } = waiting;
    const number = newest;
    waiting = null;
    busy = true;
    try {
      const answer = await asking(question);
      if (number === newest) answered(answer, question);
    } catch (error) {
      if (number === newest) failed(error, question);
    } finally {
      busy = false;
      if (waiting && timer === undefined) void next();
    }
  }

  return {
    ask(question) {
      newest += 1;
      waiting = { question };
      clearTimeout(timer);
      timer = setTimeout(() => {
        timer = undefined;
        void next();
      }, delay);
    },
    cancel() {
      newest += 1;
      waiting = null;
      clearTimeout(timer);
      timer = undefined;
    },
  };
}
