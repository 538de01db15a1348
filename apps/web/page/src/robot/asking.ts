// Asks the core what follows from the robot in the form, and from the one that it began from.
import type { MazeData, RobotAnswer } from '../core/types';
import { setMyRobot, type Origin } from '../link/my-robot';
import type { Page } from '../page/page';
import { createLatest, type Latest } from '../ui/latest';
import type { Draft } from './draft';
import type { RobotForm, Values } from './form';

export interface Question {
  name: string;
  /** Null: as it began. */
  values: Values | null;
  maze: MazeData | null;
}

export interface Answers {
  now: RobotAnswer;
  before: RobotAnswer;
}

/** `answered` hears after the draft and the form have taken the answer. */
export function createAsking(
  page: Page,
  draft: Draft,
  form: RobotForm,
  answered: (answers: Answers, question: Question) => void,
  failed: (error: unknown) => void,
): Latest<Question> {
  let began: { origin: Origin; maze: MazeData | null; answer: Promise<RobotAnswer> } | null = null;
  function beginning({ maze }: Question): Promise<RobotAnswer> {
    const { origin } = draft;
    if (began?.origin === origin && began.maze === maze) return began.answer;
    const { name, text } = origin;
    const where = maze && { maze };
    const answer =
      text === null
        ? page.core.call('robot', { name, built_in: name, ...where })
        : page.core.call('robot', { name, ...where }, new TextEncoder().encode(text));
    began = { origin, maze, answer };
    return answer;
  }
  async function ask(question: Question): Promise<Answers> {
    const before = await beginning(question);
    const { name, values, maze } = question;
    if (values === null) return { now: before, before };
    return { now: await page.core.call('robot', { name, values, ...(maze && { maze }) }), before };
  }
  function take(answers: Answers, question: Question) {
    const { now, before } = answers;
    // A form that is being edited is left alone.
    if (question.values === null || now.keys.join() !== draft.keys.join()) form.show(now.values, now.keys);
    const isSame = now.result?.tables === before.result?.tables && draft.origin.text === null;
    draft.given = now.result && !isSame ? `${question.name}\n${now.text}` : null;
    Object.assign(draft, { keys: now.keys, values: now.values, text: now.text, refused: now.result === null });
    draft.result = now.result ?? draft.result;
    setMyRobot(draft.given);
    answered(answers, question);
  }
  return createLatest(ask, take, failed);
}
