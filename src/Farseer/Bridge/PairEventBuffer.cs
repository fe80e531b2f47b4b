using System;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Events of pairs. Those of fast bodies and of what left come by themselves; most are in order as they come.</summary>
internal sealed class PairEventBuffer<T> : EventBuffer<T>
    where T : struct, IPairEvent
{
    /// <summary>Puts what came in order; equal ones stay as they came.</summary>
    protected override void Arrange(Span<T> coming)
    {
        for (int i = 1; i < coming.Length; i++)
        {
            T moved = coming[i];
            int place = i;
            for (; place > 0 && moved.Order < coming[place - 1].Order; place--)
            {
                coming[place] = coming[place - 1];
            }

            coming[place] = moved;
        }
    }
}
