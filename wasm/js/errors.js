/**
 * An error with a code for programs, a sentence for people, and the place in the input.
 * Codes from the mesher are the same in C++, on the command line and here.
 */
export class LpquadError extends Error {
  /**
   * @param {string} code
   * @param {string} message
   * @param {object} [where]
   * @param {ErrorOptions} [options]
   */
  constructor(code, message, where = {}, options) {
    super(message, options);
    this.name = 'LpquadError';
    this.code = code;
    this.where = where;
  }
}

export const disposed = () => new LpquadError('BAD_OPTION', 'This session has been disposed of.');

/** @param {string} json  {error: {code, message, where}} as the core writes it */
export function errorFromJson(json) {
  const { code, message, where } = JSON.parse(json).error;
  return new LpquadError(code, message, where);
}

/** The value of a core call, or its error thrown. */
export function unwrap(result) {
  if (result.error !== undefined) throw errorFromJson(result.error);
  return result;
}
