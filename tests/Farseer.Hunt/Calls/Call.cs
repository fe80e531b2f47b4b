using System;
using System.Collections.Generic;

namespace Farseer.Hunt.Calls;

/// <summary>One call. Its number is the name of what it makes and stays when others are left out.</summary>
/// <param name="Id">The number.</param>
/// <param name="Member">What is called.</param>
/// <param name="Arguments">By <see cref="Member.Kinds"/>.</param>
/// <param name="Inner">What a handler calls.</param>
/// <param name="Made">The type of what it makes.</param>
internal sealed record Call(int Id, Member Member, IReadOnlyList<object> Arguments, IReadOnlyList<Call> Inner, Type? Made)
{
    public static IEnumerable<Call> All(IEnumerable<Call> calls)
    {
        foreach (Call call in calls)
        {
            yield return call;
            foreach (Call inner in All(call.Inner))
            {
                yield return inner;
            }
        }
    }
}

/// <summary>A world: its calls in order, and what must hold.</summary>
internal sealed record Script(Facade Facade, Profile Profile, IReadOnlyList<Call> Calls);
