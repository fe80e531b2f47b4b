using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <summary>What a stretch of a state consists of, for those who look for a difference: records of one kind.</summary>
internal abstract unsafe class StateKind
{
    /// <summary>Bytes of a record.</summary>
    public abstract int Size { get; }

    /// <summary>A record as an object.</summary>
    public abstract object Box(byte* at);
}

/// <inheritdoc cref="StateKind"/>
internal sealed unsafe class StateKind<T> : StateKind
    where T : unmanaged
{
    public override int Size => sizeof(T);

    public override object Box(byte* at) => Unsafe.ReadUnaligned<T>(at);
}
