using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Running;

/// <summary>
/// A world as a C# program against the public API. Each statement is followed by its call as the model reads it again, so the file is
/// both what a
/// person runs and what replays; a line can be deleted by hand.
/// </summary>
internal static class ProgramText
{
    private const string Mark = " //: ";

    public static string Write(Script script, IReadOnlyDictionary<int, Outcome> outcomes, string comment, IEnumerable<int> worlds)
    {
        var text = new StringBuilder();
        foreach (string line in comment.Split('\n').Take(12))
        {
            text.Append("// ").Append(line.TrimEnd()).Append('\n');
        }

        text.Append(CultureInfo.InvariantCulture, $"// world: {script.Facade.Name} {script.Profile}\n");
        text.Append("#pragma warning disable\n");
        foreach (string used in script.Facade.Namespaces)
        {
            text.Append(CultureInfo.InvariantCulture, $"using {used};\n");
        }

        text.Append('\n');
        Dictionary<int, string> names = Call.All(script.Calls).Where(c => c.Made is not null).ToDictionary(c => c.Id, c => NameOf(c));
        foreach (Call call in Call.All(script.Calls).Where(c => c.Made is not null && outcomes.ContainsKey(c.Id)))
        {
            text.Append(CultureInfo.InvariantCulture, $"{Member.NameOf(call.Made!)} {names[call.Id]} = default;\n");
        }

        foreach (Call call in Call.All(script.Calls).Where(c => c.Member is HandlerMember))
        {
            text.Append(CultureInfo.InvariantCulture, $"int told{call.Id} = 0;\n");
        }

        foreach (Call call in script.Calls)
        {
            Write(text, call, outcomes, names, "");
        }

        foreach (int world in worlds)
        {
            text.Append(script.Facade.HashCode(names[world])).Append('\n');
        }

        text.Append("\nstatic void Try(Action act)\n{\n    try\n    {\n        act();\n    }\n    catch (Exception e)\n    {\n");
        text.Append(
            "        Console.Error.WriteLine(e.GetType().Name);\n    }\n}\n\nstatic ref T Ref<T>(T value) => ref new[] { value }[0];\n\n");
        return text.Append(script.Facade.OwnClasses()).ToString();
    }

    public static Script Read(string text, Func<string, Facade> facade)
    {
        string[] lines = text.Split('\n');
        string[] head = lines.First(l => l.StartsWith("// world: ", StringComparison.Ordinal)).Split(' ');
        Facade found = facade(head[2]);
        var types = new Dictionary<int, Type?>();
        var stack = new Stack<List<Call>>();
        stack.Push(new List<Call>());
        foreach (string line in lines.Where(l => l.Contains(Mark, StringComparison.Ordinal)))
        {
            string[] tokens = line.Substring(line.IndexOf(Mark, StringComparison.Ordinal) + Mark.Length).Split(' ',
                StringSplitOptions.RemoveEmptyEntries);
            int depth = tokens[0].Length - tokens[0].TrimStart('>').Length;
            while (stack.Count > depth + 1)
            {
                stack.Pop();
            }

            int id = int.Parse(tokens[0].TrimStart('>'), CultureInfo.InvariantCulture);
            Member member = found.Find(tokens[1]);
            object[] arguments = member.Kinds.Select((k, i) => k.Read(tokens[i + 2])).ToArray();
            Type? made = member.ResultOf?.Invoke(arguments, i => types.GetValueOrDefault(i)) ?? member.Result;
            types[id] = made;
            var inner = new List<Call>();
            stack.Peek().Add(new Call(id, member, arguments, inner, made));
            if (member is HandlerMember)
            {
                stack.Push(inner);
            }
        }

        return new Script(found, Enum.Parse<Profile>(head[3]), stack.Last());
    }

    private static string NameOf(Call call)
    {
        string type = call.Made!.Name.StartsWith("b2", StringComparison.Ordinal) ? call.Made.Name.Substring(2) : call.Made.Name;
        return string.Create(CultureInfo.InvariantCulture, $"{char.ToLowerInvariant(type[0])}{type.Substring(1)}{call.Id}");
    }

    private static void Write(StringBuilder text, Call call, IReadOnlyDictionary<int, Outcome> outcomes, Dictionary<int, string> names,
        string indent)
    {
        string again = Mark + new string('>', indent.Length / 4) + string.Join(' ', call.Arguments.Select((a, i)
            => call.Member.Kinds[i].Token(a))
            .Prepend(call.Member.Key).Prepend(call.Id.ToString(CultureInfo.InvariantCulture))) + "\n";
        Outcome outcome = outcomes.GetValueOrDefault(call.Id, Outcome.Skipped);
        if (outcome == Outcome.Skipped)
        {
            text.Append(indent).Append("// Not reached.").Append(again);
            foreach (Call inner in call.Inner)
            {
                Write(text, inner, outcomes, names, indent + "    ");
            }

            return;
        }

        string[] arguments = call.Arguments.Select((a, i) => call.Member.Kinds[i].Code(a, id => names.GetValueOrDefault(id,
            "null"))).ToArray();
        string code = call.Member.Code(arguments);
        if (call.Member is HandlerMember handler)
        {
            text.Append(indent).Append(code).Append(again).Append(indent).Append("{\n");
            text.Append(CultureInfo.InvariantCulture, $"{indent}    if (++told{call.Id} == {arguments[1]})\n{indent}    {{\n");
            foreach (Call inner in call.Inner)
            {
                Write(text, inner, outcomes, names, indent + "    ");
            }

            string answer = arguments[2] == "0" ? "true" : $"told{call.Id} % {arguments[2]} != 0";
            text.Append(
                CultureInfo.InvariantCulture,
                $"{indent}    }}\n{(handler.ReturnsFlag ? $"{indent}    return {answer};\n" : "")}{indent}}};\n");
            return;
        }

        code = call.Made is null ? code
            : call.Member.Result == call.Made || call.Member.Result is null ? $"{names[call.Id]} = {code}"
            : $"{names[call.Id]} = ({Member.NameOf(call.Made)}){code}";
        code = outcome == Outcome.Refused && call.Member is not ThrowMember
            ? $"Try(() => {(call.Made is null ? code : "_ = (" + code + ")")});" : code + ";";
        string repeat = call.Member is StepMember && arguments[2] != "1" && indent.Length == 0
            ? $"for (int i = 0; i < {arguments[2]}; i++) " : "";
        text.Append(indent).Append(repeat).Append(code).Append(again);
    }
}
