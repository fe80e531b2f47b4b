using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using Farseer.Hunt.Running;

namespace Farseer.Hunt.Calls;

/// <summary>The model of a public API: all that can be called, how worlds begin, and what is seen of them.</summary>
internal abstract class Facade
{
    private readonly Dictionary<string, Member> _byKey;

    protected Facade(Catalogue catalogue, StepMember step, IEnumerable<Member> more)
    {
        Catalogue = catalogue;
        Step = step;
        Members = catalogue.Members.Concat(more).Append(step).ToList();
        _byKey = Members.Append(Throw).ToDictionary(m => m.Key, StringComparer.Ordinal);
    }

    public abstract string Name { get; }

    public Catalogue Catalogue { get; }

    public IReadOnlyList<Member> Members { get; }

    /// <summary>Members that change nothing.</summary>
    public IReadOnlyList<Member> Looks => Catalogue.Looks;

    public StepMember Step { get; }

    public Member Throw { get; } = new ThrowMember();

    /// <summary>The type of a world, which a step belongs to.</summary>
    public abstract Type World { get; }

    /// <summary>Namespaces of a printed program.</summary>
    public abstract IReadOnlyList<string> Namespaces { get; }

    /// <summary>C# that prints the hash of a world.</summary>
    public virtual string HashCode(string world) => $"Try(() => Console.WriteLine({world}.MotionHash()));";

    public Member Find(string key) => _byKey.TryGetValue(key, out Member? found) ? found
        : throw new ArgumentException("There is no member " + key);

    /// <summary>What a world begins with.</summary>
    public abstract void Open(Decoder decoder);

    /// <summary>Where the bodies of a new world stand: apart, so that nothing is pushed out at the beginning.</summary>
    protected static Vector2 PlaceOf(int i, int columns) => new(2.6f * ((i % columns) - (columns / 2)), 1.3f + (2.6f * (i / columns)));

    /// <summary>Some calls that make something whole: a body with a shape, a joint at the place of its bodies.</summary>
    public abstract void Compose(Decoder decoder);

    public abstract Observer Observe();

    /// <summary>C# of the classes that a printed program derives from the facade's.</summary>
    public string OwnClasses()
    {
        using Stream stream = typeof(Facade).Assembly.GetManifestResourceStream("Own." + Name)!;
        using var reader = new StreamReader(stream);
        return string.Join('\n', reader.ReadToEnd().Split('\n').SkipWhile(l => !l.StartsWith("/// <summary>", StringComparison.Ordinal)));
    }
}
