using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Running;

/// <summary>
/// Makes a failing world small: leaves calls out, in ever smaller runs, and makes arguments simpler, as long as the same kind of
/// failure comes. (A library that
/// shrinks generates smaller worlds anew, or knows plain lists; calls whose numbers stay, with calls in handlers, are left out better
/// here.)
/// </summary>
internal sealed class Shrinker(Func<Script, bool> fails, TimeSpan patience)
{
    private readonly DateTime _end = DateTime.UtcNow + patience;

    private bool IsOver => DateTime.UtcNow > _end;

    public Script Shrink(Script script)
    {
        int before;
        do
        {
            before = Size(script);
            script = LeaveOut(script);
            script = Simplify(script);
        }
        while (Size(script) < before && !IsOver);
        return script;
    }

    private static int Size(Script script) => Call.All(script.Calls).Count();

    private static Script Without(Script script, HashSet<int> gone) => script with { Calls = Without(script.Calls, gone) };

    private static List<Call> Without(IEnumerable<Call> calls, HashSet<int> gone) =>
        calls.Where(c => !gone.Contains(c.Id)).Select(c => c.Inner.Count == 0 ? c : c with { Inner = Without(c.Inner, gone) }).ToList();

    private static Script With(Script script, Call changed) => script with { Calls = With(script.Calls, changed) };

    private static List<Call> With(IEnumerable<Call> calls, Call changed) =>
        calls.Select(c => c.Id == changed.Id ? changed : c.Inner.Count == 0 ? c : c with { Inner = With(c.Inner, changed) }).ToList();

    private Script LeaveOut(Script script)
    {
        for (int run = Math.Max(1, Size(script) / 2); run >= 1 && !IsOver; run /= 2)
        {
            List<int> ids = Call.All(script.Calls).Select(c => c.Id).ToList();

            // From the end: what comes last depends on what comes first.
            for (int from = ids.Count - run; from > -run && !IsOver; from -= run)
            {
                int first = Math.Max(0, from);
                Script shorter = Without(script, ids.Skip(first).Take(from + run - first).ToHashSet());
                if (Size(shorter) < Size(script) && fails(shorter))
                {
                    script = shorter;
                }
            }
        }

        return script;
    }

    private Script Simplify(Script script)
    {
        foreach (int id in Call.All(script.Calls).Select(c => c.Id).ToList())
        {
            for (int i = 0; i < Call.All(script.Calls).First(c => c.Id == id).Arguments.Count; i++)
            {
                script = Simplify(script, id, i);
            }
        }

        return script;
    }

    private Script Simplify(Script script, int id, int index)
    {
        // A value that was made simpler may be made simpler again.
        for (int round = 0; round < 8 && !IsOver; round++)
        {
            Call call = Call.All(script.Calls).First(c => c.Id == id);
            Script? simpler = call.Member.Kinds[index].Simpler(call.Arguments[index])
                .Select(v => With(script, call with { Arguments = call.Arguments.Select((a, i) => i == index ? v : a).ToArray() }))
                .FirstOrDefault(s => !IsOver && fails(s));
            if (simpler is null)
            {
                break;
            }

            script = simpler;
        }

        return script;
    }
}
