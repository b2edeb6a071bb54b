// Does a value at run time have the type that a declaration file gives it?
import ts from 'typescript';

/** The members of an interface of a declaration file, with a checker to look into their types. */
export function readInterface(file: string, name: string) {
  const program = ts.createProgram([file], {
    strict: true,
    target: ts.ScriptTarget.ES2022,
    lib: ['lib.es2022.d.ts', 'lib.dom.d.ts'],
    types: [],
    noEmit: true,
  });
  const source = program.getSourceFile(file);
  const checker = program.getTypeChecker();
  const symbol = checker
    .getExportsOfModule(checker.getSymbolAtLocation(source!)!)
    .find((exported) => exported.name === name);
  if (!symbol) throw new Error(`${file} exports no ${name}`);
  return { checker, members: checker.getDeclaredTypeOfSymbol(symbol).getProperties() };
}

/** Empty if `value` conforms to `type`; else where and why not. Objects may have no undeclared keys. */
export function nonconformity(
  value: unknown,
  type: ts.Type,
  checker: ts.TypeChecker,
  path = 'value',
): string {
  if (type.isUnion()) {
    const reasons = type.types.map((member) => nonconformity(value, member, checker, path));
    return reasons.includes('') ? '' : reasons.join(' | ');
  }
  if (type.isLiteral()) return value === type.value ? '' : `${path} is not ${type.value}`;
  const text = checker.typeToString(type);
  if (type.flags & (ts.TypeFlags.BooleanLike | ts.TypeFlags.Null | ts.TypeFlags.Undefined)) {
    const fits = text === 'boolean' ? typeof value === 'boolean' : String(value) === text;
    return fits ? '' : `${path} is ${String(value)}, not ${text}`;
  }
  if (type.flags & (ts.TypeFlags.Number | ts.TypeFlags.String)) {
    return typeof value === text ? '' : `${path} is a ${typeof value}, not a ${text}`;
  }
  if (type.flags & ts.TypeFlags.Void) return value === undefined ? '' : `${path} is not void`;
  const buffer = /^(Uint8Array|Uint32Array|Float64Array)/.exec(text)?.[1];
  if (buffer) {
    const found = Object.prototype.toString.call(value).slice(8, -1);
    return found === buffer ? '' : `${path} is a ${found}, not a ${buffer}`;
  }
  if (typeof value !== 'object' || value === null) return `${path} is no object: ${String(value)}`;
  if (checker.isTupleType(type) || checker.isArrayType(type)) {
    if (!Array.isArray(value)) return `${path} is no array`;
    const elements = checker.getTypeArguments(type as ts.TypeReference);
    return value
      .map((element, i) => {
        const expected = elements[checker.isTupleType(type) ? i : 0];
        return expected
          ? nonconformity(element, expected, checker, `${path}[${i}]`)
          : `${path} is too long`;
      })
      .filter(Boolean)
      .join('; ');
  }
  const index = type.getStringIndexType() ?? type.getNumberIndexType();
  const properties = type.getProperties();
  const reasons: string[] = [];
  for (const [key, member] of Object.entries(value)) {
    const property = properties.find((candidate) => candidate.name === key);
    const expected = property ? checker.getTypeOfSymbol(property) : index;
    if (!expected) reasons.push(`${path}.${key} is not declared`);
    else reasons.push(nonconformity(member, expected, checker, `${path}.${key}`));
  }
  for (const property of properties) {
    const optional = (property.flags & ts.SymbolFlags.Optional) !== 0;
    if (!optional && !(property.name in value)) reasons.push(`${path}.${property.name} is missing`);
  }
  return reasons.filter(Boolean).join('; ');
}
