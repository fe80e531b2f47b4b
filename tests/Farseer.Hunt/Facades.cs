using System;
using System.Collections.Generic;
using Farseer.Hunt.Calls;
using Farseer.Hunt.Farseer;
using Farseer.Hunt.Flash;

namespace Farseer.Hunt;

/// <summary>The models there are.</summary>
internal static class Facades
{
    private static readonly Dictionary<string, Lazy<Facade>> _all = new(StringComparer.Ordinal)
    {
        ["farseer"] = new Lazy<Facade>(() => new FarseerFacade()),
        ["flash"] = new Lazy<Facade>(() => new FlashFacade()),
    };

    public static Facade Find(string name) => _all[name].Value;
}
